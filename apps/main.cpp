// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/main.cpp - finds the verb, and turns what it throws into a message and an exit status
#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <string>
#include <vector>

#include "cad_reader.h"
#include "interrupt.h"
#include "spigolo/core/error.h"
#include "suggest.h"
#include "verbs.h"

namespace spigolo {
namespace {

using Arguments = std::vector<std::string>;

enum Status { done = 0, internal = 1, usage = 2, bad_input = 3, no_result = 4, out_of_memory = 5 };

struct Verb {
  const char* name;
  const char* inputs;
  const char* purpose;
  void (*run)(const Arguments&);
};

constexpr std::array<Verb, 10> verbs = {{
    {"info", "FILE", "what the file holds: counts, bounds, spacing, noise, attributes", run_info},
    {"detect", "CLOUD -o OUT.ply", "label every point: surface, edge, corner, tip, border",
     run_detect},
    {"smooth", "CLOUD -o OUT.ply", "every point projected onto the sharp surface", run_smooth},
    {"lines", "CLOUD -o OUT", "feature curves and corners, for CAD", run_lines},
    {"mesh", "CLOUD -o OUT", "sharp triangle mesh", run_mesh},
    {"blend", "CLOUD CAD -o OUT.ply", "the cloud blended with a face of a CAD file", run_blend},
    {"compare", "A B", "distances of A to B and of B to A", run_compare},
    {"synth", "SHAPE -o OUT", "a constructed shape with the exact truth", run_synth},
    {"render", "FILE... -o PIC.png", "a picture without a screen", run_render},
    {"convert", "IN -o OUT", "read one format, write another", run_convert},
}};

std::string general_help() {
  std::string text =
      "spigolo - sharp features of raw point clouds\n\nusage: spigolo VERB INPUT... -o OUTPUT "
      "[options]\n\n";
  for (const Verb& verb : verbs) {
    std::string left = std::string("  ") + verb.name + " " + verb.inputs;
    left.resize(std::max<std::size_t>(left.size() + 2, 30), ' ');
    text += left + verb.purpose + "\n";
  }
  return text +
         "\n  spigolo VERB --help            options of a verb, with an example"
         "\n  spigolo --version\n"
         "\nClouds: .ply .xyz .txt .csv .pts .obj .off .stl .pcd .las; - is standard input or "
         "output."
         "\nExit status: 0 done, 1 failed inside, 2 usage, 3 bad input, 4 no result possible,"
         "\n  5 out of memory, 130 cancelled.\n"
         "\nExample:\n"
         "  spigolo synth hole -o hole.ply\n"
         "  spigolo detect hole.ply -o features.ply\n"
         "  spigolo render features.ply -o features.png\n";
}

[[noreturn]] void unknown_verb(const std::string& name) {
  std::vector<std::string> names(verbs.size());
  std::transform(verbs.begin(), verbs.end(), names.begin(), [](const Verb& v) { return v.name; });
  const bool option = name.starts_with("-");
  throw UsageError(option ? "the verb comes first, then options like '" + name + "'"
                          : "unknown verb '" + name + "'" + suggestion(name, names));
}

void dispatch(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("no verb given; one of info, detect, compare, synth ...");
  const std::string& name = arguments.front();
  if (name == "--version") {
    std::puts("spigolo " SPIGOLO_VERSION);
  } else if (name == "--help" || name == "-h" || name == "help") {
    std::fputs(general_help().c_str(), stdout);
  } else if (name == serve_cad_verb) {
    run_serve_cad({arguments.begin() + 1, arguments.end()});
  } else {
    const auto verb =
        std::find_if(verbs.begin(), verbs.end(), [&](const Verb& v) { return name == v.name; });
    if (verb == verbs.end()) unknown_verb(name);
    verb->run({arguments.begin() + 1, arguments.end()});
  }
}

// Where more is to be read about a wrong command line.
std::string help_hint(const Arguments& arguments) {
  const bool known =
      !arguments.empty() && std::any_of(verbs.begin(), verbs.end(),
                                        [&](const Verb& v) { return arguments.front() == v.name; });
  return "; see 'spigolo " + (known ? arguments.front() + " " : std::string()) + "--help'";
}

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "spigolo: %s\n", message.c_str());
  return status;
}

int run(const Arguments& arguments) {
  try {
    dispatch(arguments);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return fail(internal, "standard output cannot be written");
    return done;
  } catch (const UsageError& error) {
    return fail(usage, error.what() + help_hint(arguments));
  } catch (const InputError& error) {
    return fail(bad_input, error.what());
  } catch (const NoResultError& error) {
    return fail(no_result, error.what());
  } catch (const MemoryError& error) {
    return fail(out_of_memory, error.what());
  } catch (const Cancelled&) {
    return fail(status_cancelled, "cancelled; no output written");
  } catch (const Error& error) {
    return fail(internal, error.what());
  } catch (const std::bad_alloc&) {
    return fail(out_of_memory, "out of memory; thin the cloud or use a larger machine");
  } catch (const std::exception& error) {
    return fail(internal, std::string("failed inside: ") + error.what());
  }
}

}  // namespace
}  // namespace spigolo

int main(int argc, char** argv) {
  spigolo::exit_on_interrupt();
  return spigolo::run({argv + std::min(argc, 1), argv + argc});
}
