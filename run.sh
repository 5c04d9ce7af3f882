#!/usr/bin/env bash
# Takes a fresh checkout on Debian 12; gives a played match, or a server.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$root/packaging/setup.sh"

usage() {
    cat <<'TEXT'
./run.sh                   set up, build, and play a demonstration match: a real server, two
                           players and a spectator, each a process of its own, over TCP; the
                           match is left in build/demo/match.billiards
./run.sh [OPTIONS]         the same, with options of billiards-demo: --race N, --seed K ...
./run.sh --server [ARGS]   set up, build, and host; ARGS are those of billiards-server
./run.sh play|watch ...    set up, build, and join a server as a player or a spectator
./run.sh --help            this text

The programs are left in build/bin/; each has its own --help.
TEXT
}

case "${1:-}" in
    -h | --help)
        usage
        exit 0
        ;;
esac

install_packages build client
configure_and_build release programs -DBILLIARDS_TESTS=OFF

if [ "${1:-}" = --server ]; then
    shift
    exec "$root/build/bin/billiards-server" "$@"
fi
case "${1:-}" in
    play | watch) exec "$root/build/bin/billiards-demo" "$@" ;;
esac
mkdir -p "$root/build/demo"
exec "$root/build/bin/billiards-demo" --keep "$root/build/demo/match.billiards" "$@"
