#!/usr/bin/env bash
# Takes a folder of programs (default: build/bin) and options of billiards-load (default: 10,000
# sessions, of which 2,000 play); kills a server with -9 once everybody is in place, starts it again,
# and prints what the load generator measured.
set -euo pipefail
bin=${1:-build/bin}
shift || true
[ $# -gt 0 ] || set -- --tables 1000 --spectators 8000
data=$(mktemp -d)
server_pid=
load_pid=
clean_up() {
    for pid in $load_pid $server_pid; do kill -9 "$pid" 2>/dev/null || true; done
    rm -rf "$data"
}
trap clean_up EXIT

# Sets server_pid and port. The first time any free port is taken.
start_server() {
    "$bin/billiards-server" --listen "127.0.0.1:${port:-0}" --data "$data/data" >"$data/log" 2>&1 &
    server_pid=$!
    local line
    line=$(wait_for "$data/log" 'listening on 127.0.0.1:')
    port=${line##*:}
}

# The first line with the text $2 in the file $1, within two minutes.
wait_for() {
    for _ in {1..1200}; do
        grep -m 1 -- "$2" "$1" 2>/dev/null && return 0
        sleep 0.1
    done
    return 1
}

start_server
"$bin/billiards-load" --server "127.0.0.1:$port" --mode reconnect --seconds 120 "$@" \
    >"$data/report" 2>"$data/errors" &
load_pid=$!
wait_for "$data/errors" 'in place' >"$data/ready"
kill -9 "$server_pid"
wait "$server_pid" 2>/dev/null || true
start_server
wait "$load_pid"
cat "$data/errors" >&2
cat "$data/report"
