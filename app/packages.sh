# What Springstep needs, as Debian 12 packages, each with what it is for; read by app/run, tests/run,
# tests/bench/run, tests/fuzz/run, tests/package/run and .ci/run.

app_packages=(
    "clang                   the C++20 compiler, which takes half the time of g++"
    "cmake                   configures the build"
    "ninja-build             runs the build"
    "qt6-base-dev            the window, files and plugins"
    "qt6-svg-dev             the window's icons"
    "qt6-l10n-tools          translations of the texts"
    "qt6-tools-dev           the same, as CMake finds it"
    "qt6-translations-l10n   the window system's own words (file dialogs, keys) in other languages"
    "libeigen3-dev           arrays of the simulation core"
    "libqscintilla2-qt6-dev  the code panel"
    "libqcustomplot-dev      axes and grids of the plots"
    "rapidjson-dev           reads and writes JSON, and tells the line of every value"
    "libgif-dev              writes films as GIF files"
    "libvpx-dev              encodes films as video"
    "pkg-config              finds libvpx"
    "angelscript-dev         runs the programs that learners write"
    "zlib1g-dev              makes experiments short enough for a message"
    "fonts-inter             the typeface of the window"
    "fonts-hack              the typeface of code and numbers"
)
test_packages=(
    "libbenchmark-dev        tests/bench"
    "libwebm-dev             reads films again, to compare their pictures"
    "xvfb                    tests/smoke: an X server without a screen"
    "xauth                   the same, for xvfb-run"
    "xdotool                 tests/smoke: mouse and keys for that server"
    "chromium                tests/web: opens web pages of runs"
    "valgrind                counts the instructions that effects take"
)
# Others' solvers, to compare ours with; the benchmarks run without them, too.
bench_packages=(
    "libboost-dev            tests/bench: Boost's odeint"
    "libsundials-dev         tests/bench: SUNDIALS' CVODE"
    "libbox2d-dev            tests/bench: Box2D, a physics engine, on the same springs"
    "libchipmunk-dev         tests/bench: Chipmunk, likewise"
)
# For tests/run --sanitize and tests/fuzz/run.
sanitizer_packages=(
    "libclang-rt-dev         AddressSanitizer, UndefinedBehaviorSanitizer and libFuzzer"
    "llvm                    names the functions in their reports"
)
# To make the Debian packages, and to check them.
package_packages=(
    "dpkg-dev                finds the packages that ours depend on"
    "file                    finds the programs and libraries in a package"
    "lintian                 tests/package: checks the packages"
    "desktop-file-utils      the same for the desktop entry"
    "appstream               the same for the description in software centres"
    "zsh                     the same for its completion"
    "fish                    likewise"
    "debootstrap             makes a bare Debian to install them in"
    "gpgv                    checks the signature of that Debian"
)
format_packages=(
    "clang-format-14         checks the layout of the code"
)

# need ENTRY...: installs those that are missing; needs no network when none is. Talks on stderr only.
need() {
    if ! command -v apt-get >/dev/null; then
        echo "This system has no apt-get. If the build stops, install these (Debian's names):" >&2
        printf '  %s\n' "$@" >&2
        return
    fi
    local entry missing=() installed
    installed=" $(dpkg-query -W -f '${Package}:${db:Status-Status} ' 2>/dev/null) "
    for entry in "$@"; do
        [[ $installed == *" ${entry%% *}:installed "* ]] || missing+=("$entry")
    done
    ((${#missing[@]})) || return 0
    echo "Springstep needs these packages, which apt-get installs now:" >&2
    printf '  %s\n' "${missing[@]}" >&2
    local root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null || {
            echo "Installing needs root. Run as root: apt-get install ${missing[*]%% *}" >&2
            return 1
        }
        root=(sudo)
    fi
    "${root[@]}" apt-get update >&2 </dev/null
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends "${missing[@]%% *}" >&2 </dev/null
}

# quietly COMMAND...: runs it and shows what it prints only if it fails.
quietly() {
    local log
    log=$("$@" 2>&1 </dev/null) || {
        local code=$?
        printf '%s\n' "$log" >&2
        return "$code"
    }
}

# build FOLDER [OPTION...]: builds, and tells on stderr how many of all steps are done.
build() {
    local folder=$1
    shift
    NINJA_STATUS='[%f of %t] ' cmake --build "$folder" "$@" >&2 </dev/null
}

# configure PRESET OPTION...: sets up the preset's build folder; with ccache where that is installed.
configure() {
    local preset=$1 options=()
    shift
    if command -v ccache >/dev/null; then
        options=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    fi
    # CMake forgets all other options of a folder in which the compiler changes.
    if ! grep -qs '^CMAKE_CXX_COMPILER:.*clang++$' "build/$preset/CMakeCache.txt"; then
        options+=(--fresh)
    fi
    echo "Setting up build/$preset." >&2
    quietly cmake --preset "$preset" "${options[@]}" "$@"
}
