# Takes the lists of packages beside it; gives run.sh and test.sh their common steps. Sourced, not run.

say() { printf '%s\n' "$*"; }
fail() {
    printf '%s\n' "$*" >&2
    exit 1
}

# Installs what is missing of the named lists, or prints the exact command and stops.
install_packages() {
    local list package missing=()
    for list in "$@"; do
        while read -r package; do
            case "$package" in '' | '#'*) continue ;; esac
            dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' ||
                missing+=("$package")
        done <"$root/packaging/packages-$list.txt"
    done
    [ ${#missing[@]} -eq 0 ] && return 0

    local install=(apt-get install -y --no-install-recommends "${missing[@]}")
    command -v apt-get >/dev/null ||
        fail "This system has no apt-get. Install what these Debian packages hold, then try again: ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo)
        else
            fail "Packages are missing, and only root can install them. Run as root, then try again:
  apt-get update && ${install[*]}"
        fi
    fi
    say "Installing ${#missing[@]} packages: ${missing[*]}"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq ||
        fail "Updating the package lists failed: is this machine online, and may you become root? To do it by hand:
  apt-get update && ${install[*]}"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" -qq >/dev/null ||
        fail "Installing failed. Run this to see why: ${as_root[*]} ${install[*]}"
}

# configure_and_build PRESET TARGET [CMAKE OPTION ...]
configure_and_build() {
    local preset=$1 target=$2
    shift 2
    (cd "$root" && cmake --preset "$preset" "$@" >/dev/null && cmake --build --preset "$preset" --target "$target") ||
        fail "The build failed; the first error above says where."
}
