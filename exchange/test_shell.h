// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_shell.h
/// Runs of the test halves, by mpirun.
#pragma once

#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <string>

/// How a command ended, and all that it printed.
struct Outcome {
  int code = -1;
  double seconds = 0;
  std::string text;
  bool says(const std::string& s) const { return text.find(s) != std::string::npos; }
};

inline Outcome shell(const std::string& command) {
  Outcome o;
  const auto start = std::chrono::steady_clock::now();
  FILE* pipe = popen(("timeout -k 5 50 " + command + " 2>&1").c_str(), "r");
  if (!pipe) return o;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) o.text.append(buffer, n);
  const int status = pclose(pipe);
  o.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  o.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return o;
}

inline std::string part(const char* program, int ranks, const std::string& arguments) {
  return "-np " + std::to_string(ranks) + " " + program + " " + arguments;
}

inline std::string part(const char* program, const std::string& scenario, int ranks) {
  return part(program, ranks, scenario + " " + std::to_string(ranks));
}

/// A scenario of the two test halves.
inline Outcome run(const std::string& scenario, int dem = 1, int cfd = 1,
                   const std::string& settings = "") {
  return shell("env " + settings + " " + MPIRUN + " " + part(DEM_HALF, scenario, dem) + " : " +
               part(CFD_HALF, scenario, cfd));
}
