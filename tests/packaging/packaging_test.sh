#!/usr/bin/env bash
# usage: packaging_test.sh SOURCE BUILD installs the build into a folder and tests a daemon's life cycle there
set -euo pipefail
source=$1
build=$2
folder=$(mktemp -d)
daemon=
trap 'if [[ -n $daemon ]]; then kill -KILL "$daemon" 2> /dev/null || true; fi; rm -rf "$folder"' EXIT
fail() {
  echo "failed: $*" >&2
  exit 1
}
# the first port in a file, once it is there
port_in() {
  for _ in $(seq 600); do
    [[ -s $1 ]] && break
    sleep 0.1
  done
  head -n 1 "$1"
}

# The groups of packages that the Dockerfile and ./dev install: none is empty, none names a package twice, and a group
# that does not exist is an error.
mapfile -t packages < <("$source/packaging/packages.sh" engine daemon tests measuring packaging checking)
for package in build-essential cmake libssl-dev libgtest-dev libbenchmark-dev clang-tidy; do
  [[ " ${packages[*]} " == *" $package "* ]] || fail "$package is not in packages.txt"
done
[[ -z $(printf '%s\n' "${packages[@]}" | sort | uniq -d) ]] || fail "packages.txt names a package twice"
! "$source/packaging/packages.sh" nonsense 2> /dev/null || fail "a group that does not exist was accepted"

# The build that the Dockerfile runs finds what it needs, and knows every option that it is given.
"$source/packaging/build.sh" configure "$folder/build" > "$folder/configured" 2>&1 || fail "$(< "$folder/configured")"
! grep -q 'not used by the project' "$folder/configured" || fail "$(< "$folder/configured")"

# The step that the Dockerfile runs, and its expected results.
"$source/packaging/build.sh" install "$build" "$folder/usr" > /dev/null
for file in bin/selvaged bin/selvage libexec/selvage/healthcheck.sh lib/systemd/system/selvaged.service share/man/man1/selvage.1 \
  share/bash-completion/completions/selvage; do
  [[ -f $folder/usr/$file ]] || fail "$file was not installed"
done
selvaged=$folder/usr/bin/selvaged
[[ $("$selvaged" --version) == 'selvaged '[0-9]* ]] || fail "--version"

# Every library it links comes with the packages that the image installs.
mapfile -t packages < <(grep -v '^#' "$source/packaging/packages-run.txt")
known=$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces \
  --no-enhances "${packages[@]}" libc6 libstdc++6 2> /dev/null | grep '^[a-z]' | sort -u)
for library in $(ldd "$selvaged" "$folder/usr/bin/selvage" | awk '$2 == "=>" {print $3}' | sort -u); do
  package=$({ dpkg-query -S "$library" "$(readlink -f "$library")" "/usr$library" 2> /dev/null || true; } |
    head -n 1 | cut -d: -f1)
  grep -qx "$package" <<< "$known" || fail "$library is of '$package', which the image does not install"
done

# The container's configuration, moved into the folder.
printf 'a token of the test only\n' > "$folder/token"
sed -e "s|/run/secrets/selvage-token|$folder/token|; s|/var/lib/selvage|$folder|; s|0.0.0.0:7171|0.0.0.0:0|; s|127.0.0.1:7172|127.0.0.1:0|" \
  "$source/packaging/container.toml" > "$folder/selvaged.toml"
"$selvaged" --config "$folder/selvaged.toml" --check-config > /dev/null || fail "--check-config"
! "$selvaged" --config "$source/packaging/container.toml" --check-config 2> "$folder/refusal" || fail "no token was missed"
grep -q -- '--token-file' "$folder/refusal" || fail "the refusal does not name --token-file"
code=0
"$selvaged" --config "$source/packaging/container.toml" 2> /dev/null || code=$?
grep -qE "^RestartPreventExitStatus=(.* )?$code( .*)?\$" "$source/packaging/selvaged.service" || fail "a bad configuration, started again"
grep -qE '^RestartPreventExitStatus=(.* )?78( .*)?$' "$source/packaging/selvaged.service" || fail "a store of a later version, started again"
# Otherwise systemd would end the daemon when its threads ask for their time slices.
grep -qE '^SystemCallFilter=(.* )?sched_setattr( .*)?$' "$source/packaging/selvaged.service" || fail "a daemon that may not ask for time slices"
grep -q '^RestrictRealtime=no$' "$source/packaging/selvaged.service" || fail "a daemon without real-time priorities"
# Real-time priorities, with no privilege but the limit of the unit.
if ((EUID == 0)) && prlimit --rtprio=3 true 2> /dev/null; then
  limit=$(sed -n 's/^LimitRTPRIO=//p' "$source/packaging/selvaged.service")
  prlimit --rtprio="${limit:-0}" setpriv --bounding-set=-all --inh-caps=-all --no-new-privs --reuid=65534 --regid=65534 --clear-groups \
    "$selvaged" --listen 127.0.0.1:0 > "$folder/port" 2> "$folder/log" &
  daemon=$!
  port_in "$folder/port" > /dev/null
  kill -TERM "$daemon"
  wait "$daemon" || fail "exit code $? after SIGTERM: $(< "$folder/log")"
  grep -q 'real-time priorities for the threads' "$folder/log" || fail "no real-time priorities: $(< "$folder/log")"
fi

"$selvaged" --config "$folder/selvaged.toml" --port-file "$folder/port" > /dev/null 2> "$folder/log" &
daemon=$!
port=$(port_in "$folder/port")
healthcheck=$folder/usr/libexec/selvage/healthcheck.sh
"$healthcheck" "$port" || fail "the healthcheck of a daemon that lives"
"$healthcheck" "$(tail -n 1 "$folder/port")" || fail "the healthcheck by way of --listen-health"
kill -TERM "$daemon"
wait "$daemon" || fail "exit code $? after SIGTERM: $(< "$folder/log")"
daemon=
! "$healthcheck" "$port" 2> /dev/null || fail "the healthcheck of a daemon that is gone"

# With its own TLS certificate.
openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -subj /CN=localhost \
  -keyout "$folder/key.pem" -out "$folder/certificate.pem" 2> /dev/null
"$selvaged" --listen 127.0.0.1:0 --tls-cert "$folder/certificate.pem" --tls-key "$folder/key.pem" \
  --port-file "$folder/tls-port" --log-level off > /dev/null &
daemon=$!
"$healthcheck" "$(port_in "$folder/tls-port")" || fail "the healthcheck of a daemon that speaks TLS"
kill -TERM "$daemon"
wait "$daemon" || fail "exit code $? after SIGTERM with TLS"
daemon=

# One that is busy lives; one that says anything but that it lives does not.
python3 - "$folder/other-port" << 'EOF' &
import http.server
import sys


class Busy(http.server.BaseHTTPRequestHandler):
    alive = [200, 500]  # what is said of it, one after another

    def do_GET(self):
        self.protocol_version = "HTTP/1.1"
        self.send_response(self.alive.pop(0) if self.path == "/healthz" else 503)
        self.end_headers()

    def log_message(self, *_):
        pass


server = http.server.HTTPServer(("127.0.0.1", 0), Busy)
with open(sys.argv[1], "w") as file:
    print(server.server_port, file=file)
server.serve_forever()
EOF
daemon=$!
port=$(port_in "$folder/other-port")
"$healthcheck" "$port" || fail "the healthcheck of a daemon that is busy"
! "$healthcheck" "$port" || fail "the healthcheck of what does not say that it lives"
kill -KILL "$daemon"
wait "$daemon" 2> /dev/null || true
daemon=

# The unit's words are those that systemd knows; its paths are those of the folder.
if command -v systemd-analyze > /dev/null; then
  sed "s|/usr/bin/selvaged|$selvaged|; s|^#Load|Load|" "$source/packaging/selvaged.service" > "$folder/selvaged.service"
  complaints=$(systemd-analyze verify "$folder/selvaged.service" 2>&1 | grep 'selvaged.service' | grep -v 'man ' || true)
  [[ -z $complaints ]] || fail "$complaints"
fi
echo "installed, ready, drained"
