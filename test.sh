#!/usr/bin/env bash
# Takes a fresh checkout on Debian 12; gives the result of every test.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$root/packaging/setup.sh"

usage() {
    cat <<'TEXT'
./test.sh                set up, build, and run every test
./test.sh --sanitize     the same under AddressSanitizer and UndefinedBehaviorSanitizer
./test.sh --thread       the same under ThreadSanitizer
./test.sh --clang        the same, built by clang-14
./test.sh [MODE] ARGS    ARGS go to ctest: -R REGEX runs only the tests whose names match
./test.sh --help         this text

Each mode builds in a folder of its own: build, build-sanitize, build-thread, build-clang.
TEXT
}

preset=release
packages=(build client test)
case "${1:-}" in
    -h | --help)
        usage
        exit 0
        ;;
    --sanitize | --thread)
        preset=${1#--}
        shift
        ;;
    --clang)
        preset=clang
        packages+=(ci)
        shift
        ;;
esac

install_packages "${packages[@]}"
configure_and_build "$preset" all -DBILLIARDS_TESTS=ON -DBILLIARDS_CLIENT=ON "-DBILLIARDS_WERROR=${CI:+ON}"
cd "$root" && exec ctest --preset "$preset" --output-on-failure "$@"
