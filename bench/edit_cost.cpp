// What one mouse move of a drag costs in homes of growing size: the preview with its validation, and the diff
// that views follow. Both should stay flat while the home grows a hundredfold.
#include <benchmark/benchmark.h>

#include "model/diff.h"
#include "model/document.h"
#include "support/sample_home.h"

namespace {

using namespace idap;

Home moved(const Home& home, double x) {
  Home next = home;
  const FurnitureId id{home.furniture.size() / 2};
  Furniture piece = *home.furniture.find(id);
  piece.position.x = x;
  next.furniture.set(id, std::move(piece));
  return next;
}

void preview(benchmark::State& state) {
  Document document(test::manyPieces(static_cast<int>(state.range(0))));
  document.begin("Move");
  double x = 0;
  for (auto _ : state) document.preview([&](const Home& home) { return moved(home, x += 0.001); });
}
BENCHMARK(preview)->RangeMultiplier(10)->Range(100, 10'000);

void diffOfOneMove(benchmark::State& state) {
  const Home before = test::manyPieces(static_cast<int>(state.range(0)));
  const Home after = moved(before, 1);
  for (auto _ : state) benchmark::DoNotOptimize(diff(before, after));
}
BENCHMARK(diffOfOneMove)->RangeMultiplier(10)->Range(100, 10'000);

}  // namespace

BENCHMARK_MAIN();
