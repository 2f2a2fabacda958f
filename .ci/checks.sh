# shellcheck shell=bash
# The checks of `./run check`, which sources this file: check_<name> for each of all_checks. Each has
# a build folder of its own below build/, and fails by a message and an exit code.
# shellcheck disable=SC2154  # root and build are set by run

# Without names all run but docs, which walks a robot for minutes and is part of a release.
usual_checks=(address threads fuzz tidy format shell site)
all_checks=("${usual_checks[@]}" docs)

# Seconds for each fuzzer, and for all of clang-tidy.
fuzz_seconds=${FUZZ_SECONDS:-60}
tidy_seconds=${TIDY_SECONDS:-480}

# Undefined behaviour ends a program.
strict=-fno-sanitize-recover=undefined

sources() {
  find src test -name '*.h' -o -name '*.cpp' | sort
}

# Nothing for clang-format to change.
check_format() {
  sources | xargs clang-format --dry-run -Werror
}

# No remark of shellcheck.
check_shell() {
  shellcheck run .ci/run .ci/checks.sh
}

# The documents are a site without a broken link.
check_site() {
  mkdocs build --quiet --strict
}

# Every command of the pages does what it says.
check_docs() {
  build all && /usr/bin/python3 doc/run_commands.py
}

# Prints the C++ sources that changed since main, or on main itself in the last commit, and those
# whose header did.
changed_sources() {
  local base file
  base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null) || true
  if [[ -z $base || $base == $(git rev-parse HEAD) ]]; then base=HEAD~1; fi
  git rev-parse -q --verify "$base^{commit}" >/dev/null || return 0
  git diff --name-only --diff-filter=d "$base" -- 'src/*.h' 'src/*.cpp' 'test/*.cpp' |
    while read -r file; do
      file=${file%.h}
      file=${file%.cpp}.cpp
      if [[ -e $file ]] && grep -q "\"file\": \"$root/$file\"" "$build/tidy/compile_commands.json"; then
        echo "$file"
      fi
    done | sort -u
}

# No remark of clang-tidy about what changed, each source by itself, as far as it gets in its time.
check_tidy() {
  local files ended=0
  cmake -S "$root" -B "$build/tidy" -DPYTHON_EXECUTABLE=/usr/bin/python3 &&
    cmake --build "$build/tidy" --target hexapod_repertoire_generate_messages_cpp || return
  mapfile -t files < <(changed_sources)
  if ((${#files[@]} == 0)); then return 0; fi
  printf '%s\n' "${files[@]}" | timeout "$tidy_seconds" xargs -P"$(nproc)" -n1 \
    clang-tidy -p "$build/tidy" --quiet --warnings-as-errors='*' || ended=$?
  if ((ended == 124)); then
    say "clang-tidy did not get through all ${#files[@]} changed files in $tidy_seconds s"
    return 0
  fi
  return $ended
}

# Prints the GoogleTest programs of the given stations.
test_programs() {
  local station
  for station in "$@"; do
    sed -nE 's/^hexapod_test\((\w+).*/test_\1/p' "test/$station/CMakeLists.txt"
  done
}

# Prints the stations whose tests need no ROS.
core_stations() {
  find test -mindepth 2 -maxdepth 2 -name CMakeLists.txt -printf '%h\n' |
    sed 's:^test/::' | grep -vx ros_interface | sort
}

# Configures build/<name> with the given compiler flags and builds the targets in targets[@], which is the
# caller's, as in what follows. With Ninja, since CMake's makefiles build several targets one by one.
build_sanitized() {
  local name=$1 flags=$2
  shift 2
  use_compiler_cache
  [[ -e $build/$name/build.ninja ]] || rm -rf "${build:?}/$name"
  cmake -G Ninja -S "$root" -B "$build/$name" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O1 -g1 $flags" "${unity[@]}" "$@" \
    >"$build/$name.log" 2>&1 &&
    cmake --build "$build/$name" -j"$(parallel_jobs)" --target "${targets[@]}" \
      >>"$build/$name.log" 2>&1 && return
  tail -n 60 "$build/$name.log" >&2
  fail "the build failed; the whole log is $build/$name.log"
}

# The tests of the core find no memory error and no undefined behaviour. Left out are those that do the
# same many times over, whole robots that learn and walk among them: they take as long under sanitizers
# as all others together, and run nothing that others do not. What the address
# sanitizer sees of undefined behaviour, too, is left to it.
check_address() {
  local targets stations
  mapfile -t stations < <(core_stations)
  mapfile -t targets < <(test_programs "${stations[@]}")
  build_sanitized address "-fsanitize=address,undefined $strict \
-fno-sanitize=null,object-size" \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON
  local again='ImportedRobots.*:*/ShippedRobots.*:ReducedOracle.EndsBehavioursWhereOdeDoes'
  again+=':FitBody.FindsTheBodyThatWalked:EngineAgreement.*:ClosedLoop.*:*EndsTheSame*'
  again+=':ResumeTest.VerifiesAnew*:VerifyTest.IsRecorded*:RobustSession.KeepsNow*:WarmStartTest.Has*'
  again+=':ImportRobot.TenLegs*:ImportRobot.Sizes*:ImportRobot.Round*:RoughFiles.Legs*'
  (cd "$build/address" && export GTEST_FILTER="-$again" &&
    export LSAN_OPTIONS="suppressions=$root/.ci/address.supp" &&
    ctest --output-on-failure -j"$(nproc)" -R "^($(IFS='|' && echo "${targets[*]}"))\$")
}

# The unit tests of executor and nodes find no data race.
check_threads() {
  local targets program core failed=0
  mapfile -t targets < <(test_programs execution ros_interface)
  build_sanitized threads '-fsanitize=thread'
  core=$(sed -nE 's/^Cpus_allowed_list:\s*([0-9]+).*/\1/p' /proc/self/status)
  for program in "${targets[@]}"; do
    # A sanitizer needs addresses that some kernels spread too wide (setarch). On one core TBB, whose
    # synchronisation it does not see, starts no threads; ours start, and what they do in whatever
    # order is judged by what they synchronise, not by when it happens.
    TSAN_OPTIONS="suppressions=$root/.ci/threads.supp halt_on_error=1 second_deadlock_stack=1" \
      setarch -R taskset -c "$core" "$build/threads/devel/lib/hexapod_repertoire/$program" ||
      failed=1
  done
  return $failed
}

# Runs one fuzzer from its seeds for a while.
fuzz() {
  local name=$1 folder=$build/fuzz/corpus/$1
  LSAN_OPTIONS="suppressions=$root/.ci/address.supp" "$build/fuzz/fuzz_$name" \
    -max_total_time="$fuzz_seconds" -timeout=10 -rss_limit_mb=4096 \
    -artifact_prefix="$build/fuzz/$name-" -verbosity=0 -print_final_stats=0 "$folder" \
    >"$build/fuzz/$name.log" 2>&1
}

# The fuzzer finds a mistake made on purpose, from its seed alone: soon, or hardly ever, since it then
# follows other traces; so it is let begin anew.
find_seeded_mistake() {
  local fuzz_seconds=10 corpus=$build/fuzz/corpus/seeded_mistake _
  for _ in {1..6}; do
    rm -rf "$corpus"
    mkdir "$corpus"
    "$build/fuzz/fuzz_seeds" "$build/fuzz/corpus"
    fuzz seeded_mistake || return 0
  done
  return 1
}

# No input makes the readers of files and messages fail otherwise than by a sentence; and a mistake
# that was made on purpose is found.
check_fuzz() {
  local targets names=(urdf yaml repertoire_file message work_message) name failed=0
  targets=(fuzzers)
  build_sanitized fuzz "-fsanitize=fuzzer-no-link,address,undefined $strict \
-DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION" \
    -DCMAKE_CXX_COMPILER=clang++ -DFUZZERS=ON
  for name in "${names[@]}" seeded_mistake; do mkdir -p "$build/fuzz/corpus/$name"; done
  cp urdf/*.urdf "$build/fuzz/corpus/urdf"
  cp config/*.yaml "$build/fuzz/corpus/yaml"
  "$build/fuzz/fuzz_seeds" "$build/fuzz/corpus"
  export -f fuzz
  export root build fuzz_seconds
  # shellcheck disable=SC2016  # the inner shell expands it
  printf '%s\n' "${names[@]}" | xargs -P"$(nproc)" -I{} bash -c \
    'fuzz "{}" || { tail -n 40 "$build/fuzz/{}.log" >&2; exit 1; }' || failed=1
  if ! find_seeded_mistake; then
    say 'the fuzzer did not find the mistake that was made on purpose'
    failed=1
  fi
  return $failed
}

# Runs one check and tells how it ended; of one that failed, what it printed.
run_check() {
  local name=$1 log=$build/check_$1.log
  SECONDS=0
  if ("check_$name") >"$log" 2>&1; then
    say "check $name passed in $SECONDS s"
    return
  fi
  cat "$log" >&2
  say "check $name failed after $SECONDS s"
  return 1
}

# Runs the named checks, the usual ones without a name, and tells which failed. Two at a time, as each
# keeps but one core busy for a while.
check() {
  local name failures=()
  local -A ids=()
  if (($# == 0)); then set -- "${usual_checks[@]}"; fi
  for name in "$@"; do
    [[ " ${all_checks[*]} " == *" $name "* ]] ||
      fail "there is no check '$name'; there are: ${all_checks[*]}"
  done
  setup checks
  cd "$root" || return
  mkdir -p "$build"
  set -m  # a process group for each, to be ended as one
  trap 'for name in "${ids[@]}"; do kill -- "-$name"; done 2>/dev/null; exit 130' INT TERM
  for name in "$@"; do
    if (($(jobs -rp | wc -l) == 2)); then wait -n || true; fi
    run_check "$name" &
    ids[$name]=$!
  done
  for name in "${!ids[@]}"; do wait "${ids[$name]}" || failures+=("$name"); done
  ((${#failures[@]} == 0)) || fail "these checks failed: ${failures[*]}"
}
