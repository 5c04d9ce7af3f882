#!/usr/bin/env bash
# Takes a fresh checkout on Debian 12; gives the game in a window, a played match, or a server.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$root/packaging/setup.sh"

usage() {
    cat <<'TEXT'
./run.sh [OPTIONS]         set up, build, and open the game; OPTIONS are those of billiards:
                           --name NAME, --size WxH ... Without a display: as with --demo
./run.sh --demo [OPTIONS]  set up, build, and play a demonstration match: a real server, two
                           players and a spectator, each a process of its own, over TCP; its
                           pictures, and the match as a replay, are left in build/demo/.
                           OPTIONS are those of billiards-demo: --race N, --seed K ...
./run.sh --server [ARGS]   set up, build, and host; ARGS are those of billiards-server. Neither
                           this nor the next needs anything to draw with
./run.sh play|watch ...    set up, build, and join a server as a simple player or a spectator
./run.sh --help            this text

The programs are left in build/bin/; each has its own --help.
TEXT
}

case "${1:-}" in
    -h | --help)
        usage
        exit 0
        ;;
    --server | play | watch)
        install_packages build
        configure_and_build release programs -DBILLIARDS_TESTS=OFF -DBILLIARDS_CLIENT=OFF
        if [ "$1" = --server ]; then
            shift
            exec "$root/build/bin/billiards-server" "$@"
        fi
        exec "$root/build/bin/billiards-demo" "$@"
        ;;
esac

install_packages build client
configure_and_build release programs -DBILLIARDS_TESTS=OFF -DBILLIARDS_CLIENT=ON

if [ "${1:-}" = --demo ]; then
    shift
elif [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec "$root/build/bin/billiards" "$@"
fi
mkdir -p "$root/build/demo"
cd "$root"
exec build/bin/billiards-demo --pictures build/demo --keep build/demo/match.billiards "$@"
