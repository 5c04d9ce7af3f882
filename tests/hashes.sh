#!/usr/bin/env bash
# Takes the tree; gives whether g++ and clang++, unoptimised and optimised, on x86-64 and AArch64,
# solve the same shots to the same bits. Compilers that are not there are left out, with a word.
set -euo pipefail
shopt -s inherit_errexit
cd "$(dirname "${BASH_SOURCE[0]}")/.."
shots=${1:-400}
export work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export launcher=$(command -v ccache || true)

# A cross compiler does not look into /usr/include: of it, only headers that fit every machine.
mkdir "$work/include"
ln -s /usr/include/glm "$work/include/glm"

compile() { # BUILD COMPILER LEVEL SOURCE
    $launcher "$2" -std=c++20 "$3" -ffp-contract=off -I. -isystem "$work/include" \
        -c "$4" -o "$work/$1/${4//\//_}.o"
}
export -f compile

digest() { # BUILD COMPILER LEVEL [RUNNER]
    mkdir "$work/$1"
    ls common/{base,model,timeline,physics}/*.cpp tests/common/physics/numbered_case.cpp tests/long/hashes_main.cpp |
        xargs -P "$(nproc)" -I{} bash -c 'compile "$@"' _ "$1" "$2" "$3" {}
    "$2" -static "$work/$1"/*.o -o "$work/$1/hashes"
    ${4:-} "$work/$1/hashes" "$shots"
}

expected=
while read -r build compiler level runner; do
    if ! command -v "$compiler" >/dev/null || ! command -v "${runner:-true}" >/dev/null; then
        echo "$build: not here"
        continue
    fi
    found=$(digest "$build" "$compiler" "$level" "$runner")
    echo "$build: $found"
    expected=${expected:-$found}
    [ "$found" = "$expected" ] || { echo "the hashes differ" >&2 && exit 1; }
done <<'BUILDS'
x86-64-g++-O3 g++-12 -O3
x86-64-g++-O0 g++-12 -O0
x86-64-clang++-O3 clang++-14 -O3
x86-64-clang++-O0 clang++-14 -O0
aarch64-g++-O3 aarch64-linux-gnu-g++ -O3 qemu-aarch64-static
aarch64-g++-O0 aarch64-linux-gnu-g++ -O0 qemu-aarch64-static
BUILDS
echo "every build gives the same hashes of $shots shots"
