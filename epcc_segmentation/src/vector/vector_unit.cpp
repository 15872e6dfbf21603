// SPDX-License-Identifier: BSD-3-Clause
// Highway's targets by name, and the choice of one.
#include "epcc_segmentation/vector_unit.h"

#include <cstdint>
#include <cstdlib>

#include "vector/dispatch.h"

namespace epcc {

namespace {

struct Unit {
  const char* name;
  std::int64_t target;
};

/// Those the kernels are built for and the processor has, the fastest first.
std::vector<Unit> units() {
  constexpr Unit kAll[] = {{"avx512", HWY_AVX3}, {"avx2", HWY_AVX2},
                           {"sse4", HWY_SSE4},   {"ssse3", HWY_SSSE3},
                           {"neon", HWY_NEON},   {HWY_ARCH_X86 != 0 ? "sse2" : "portable", HWY_STATIC_TARGET}};
  // The baseline is not among what Highway detects: every processor has it.
  const std::int64_t available = HWY_TARGETS & (hwy::SupportedTargets() | HWY_STATIC_TARGET);
  std::vector<Unit> result;
  for (const Unit& unit : kAll)
    if ((unit.target & available) != 0 && (result.empty() || result.back().target != unit.target))
      result.push_back(unit);  // on arm64 NEON is the baseline, too
  return result;
}

const Unit* unitNamed(const std::vector<Unit>& all, const std::string& name) {
  for (const Unit& unit : all)
    if (unit.name == name) return &unit;
  return nullptr;
}

const char* wanted() {
  const char* name = std::getenv("EPCC_VECTOR_UNIT");
  return name != nullptr && *name != '\0' ? name : nullptr;
}

/// The unit in use and what the environment had to say about it.
struct Choice {
  hwy::ChosenTarget target;
  std::string problem;

  Choice() {
    const std::vector<Unit> all = units();
    const Unit* unit = wanted() != nullptr ? unitNamed(all, wanted()) : &all.front();
    if (unit == nullptr) {
      problem = std::string("EPCC_VECTOR_UNIT is '") + wanted() + "'; this machine has";
      for (const Unit& available : all) problem += std::string(" ") + available.name;
      unit = &all.front();
    }
    target.Update(unit->target);
  }
};

Choice& choice() {
  static Choice the_choice;
  return the_choice;
}

}  // namespace

hwy::ChosenTarget& chosenTarget() {
  return choice().target;
}

std::vector<std::string> vectorUnits() {
  std::vector<std::string> names;
  for (const Unit& unit : units()) names.emplace_back(unit.name);
  return names;
}

std::string vectorUnit() {
  const std::size_t index = chosenTarget().GetIndex();
  for (const Unit& unit : units()) {
    hwy::ChosenTarget target;
    target.Update(unit.target);
    if (target.GetIndex() == index) return unit.name;
  }
  return {};
}

bool setVectorUnit(const std::string& name) {
  const std::vector<Unit> all = units();
  const Unit* unit = unitNamed(all, name);
  if (unit != nullptr) chosenTarget().Update(unit->target);
  return unit != nullptr;
}

std::string vectorUnitProblem() {
  return choice().problem;
}

}  // namespace epcc
