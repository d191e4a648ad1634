# What run.sh and test.sh share: packages and the build. Sourced with $root set; all chatter goes to stderr.

# install_packages GROUP...: those of packages.txt that are missing.
install_packages() {
  local wanted missing=() name status
  wanted=$(awk -v groups=" $* " '$1 !~ /^#/ && index(groups, " " $1 " ") {print $2}' "$root/packages.txt")
  declare -A installed=()
  while read -r status name; do
    [ "$status" = installed ] && installed[$name]=1
  done < <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null || true)
  for name in $wanted; do
    [ -n "${installed[$name]:-}" ] || missing+=("$name")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, and there is no sudo to install them with: ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}" >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build TARGET...: configures once, then lets Ninja see what changed. One build at a time in a tree.
build() {
  mkdir -p "$root/build"
  (
    flock 9
    if [ ! -f "$root/build/build.ninja" ]; then
      cmake -S "$root" --preset release >&2
    fi
    local output
    if [ -t 2 ]; then
      ninja -C "$root/build" "$@" >&2
    elif ! output=$(ninja -C "$root/build" "$@" 2>&1); then
      printf '%s\n' "$output" >&2
      exit 1
    fi
  ) 9>"$root/build/.lock"
}
