#include "render/denoise/network.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <oneapi/dnnl/dnnl.hpp>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "base/data_path.h"
#include "base/error.h"
#include "base/file.h"
#include "render/denoise/network_map.h"
#include "render/denoise/transfer_curve.h"
#include "render/denoise/weight_file.h"

namespace idap::render {

namespace {

constexpr int kTile = 704;       // largest tile with its margins, pixels
constexpr int kTileMargin = 96;  // what a pixel's value depends on, roughly half the receptive field of 174

int roundedUp(int n) { return (n + kBlock - 1) / kBlock * kBlock; }

std::filesystem::path weightPath(bool fast) {
  return dataFolder() / "denoiser" / (fast ? "rt_hdr_alb_nrm_small.tza" : "rt_hdr_alb_nrm.tza");
}

// Threads of oneDNN (which counts them when a primitive is made) and of our own loops; put back at the end.
class ThreadCount {
 public:
#ifdef _OPENMP
  explicit ThreadCount(int threads) : before_(omp_get_max_threads()) { omp_set_num_threads(threads); }
  ~ThreadCount() { omp_set_num_threads(before_); }
#else
  explicit ThreadCount(int) : before_(1) {}
#endif
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

 private:
  [[maybe_unused]] int before_;
};

std::uint16_t toBf16(float v) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(v);
  return static_cast<std::uint16_t>((bits + 0x7fff + ((bits >> 16) & 1)) >> 16);  // to nearest, ties to even
}

// oneDNN's fast kernels: bfloat16 only where the processor has AMX, and then channels last; float in blocks
// of 16 on AVX-512 and channels last elsewhere. Any other pairing falls to kernels that take seconds.
Format bestFormat() {
  const dnnl::cpu_isa isa = dnnl::get_effective_cpu_isa();
  const auto has = [&](dnnl::cpu_isa wanted) {
    return (static_cast<unsigned>(isa) & static_cast<unsigned>(wanted)) == static_cast<unsigned>(wanted);
  };
  if (has(dnnl::cpu_isa::avx512_core_amx)) return {true, false};
  return {false, has(dnnl::cpu_isa::avx512_core)};
}

}  // namespace

struct DenoiseNetwork::Impl {
  struct Layer {
    int in = 0, out = 0;  // padded to 16
    dnnl::memory weights, bias;
  };

  Impl(bool fast, Format f);
  Layer load(const std::string& name, int firstInput, int secondInput);
  Map convolve(const std::string& name, const Map& from, bool last = false);
  static int stripRows(const Layer& layer, const Map& from);
  Map halve(const Map& from) { return halved(from, format, pool); }
  Map join(const Map& low, const Map& skip) { return joined(low, skip, format, pool); }
  Map runOn(const Map& input);

  Format format;
  std::map<std::string, Tensor> tensors;
  std::map<std::string, Layer> layers;
  dnnl::engine engine{dnnl::engine::kind::cpu, 0};
  dnnl::stream stream{engine};
  TransferCurve curve;
  std::string implementation;
  BufferPool pool;
  const Progress* progress = nullptr;
};

// Colour, albedo and normal make 9 channels; where they are joined again, they follow the other channels.
DenoiseNetwork::Impl::Impl(bool fast, Format f) : format(f) {
  const std::filesystem::path path = weightPath(fast);
  tensors = parseWeights(readFile(path, std::size_t{256} << 20), path.string());
  constexpr int kInputs = 9;
  const auto outputs = [&](const char* name) { return layers.at(name).out; };
  const auto add = [&](const std::string& name, int first, int second = 0) {
    layers[name] = load(name, first, second);
  };
  add("enc_conv0", kInputs);
  add("enc_conv1", outputs("enc_conv0"));
  add("enc_conv2", outputs("enc_conv1"));
  add("enc_conv3", outputs("enc_conv2"));
  add("enc_conv4", outputs("enc_conv3"));
  add("enc_conv5a", outputs("enc_conv4"));
  add("enc_conv5b", outputs("enc_conv5a"));
  add("dec_conv4a", outputs("enc_conv5b"), outputs("enc_conv3"));
  add("dec_conv4b", outputs("dec_conv4a"));
  add("dec_conv3a", outputs("dec_conv4b"), outputs("enc_conv2"));
  add("dec_conv3b", outputs("dec_conv3a"));
  add("dec_conv2a", outputs("dec_conv3b"), outputs("enc_conv1"));
  add("dec_conv2b", outputs("dec_conv2a"));
  add("dec_conv1a", outputs("dec_conv2b"), kInputs);
  add("dec_conv1b", outputs("dec_conv1a"));
  add("dec_conv0", outputs("dec_conv1b"));
  if (tensors.at("dec_conv0.weight").shape[0] != 3)
    throw ParseError(path.string(), "dec_conv0", "is not a colour");
  tensors.clear();
}

DenoiseNetwork::Impl::Layer DenoiseNetwork::Impl::load(const std::string& name, int firstInput,
                                                       int secondInput) {
  const auto weight = tensors.find(name + ".weight"), bias = tensors.find(name + ".bias");
  const auto bad = [&](const char* reason) { throw ParseError("denoiser weights", name, reason); };
  if (weight == tensors.end() || bias == tensors.end()) bad("is missing");
  const Tensor& w = weight->second;
  if (w.shape.size() != 4 || w.shape[1] != firstInput + secondInput || w.shape[2] != 3 || w.shape[3] != 3 ||
      bias->second.shape != std::vector<int>{w.shape[0]}) {
    bad("has an unexpected shape");
  }
  // Channels are padded with zero weights to a multiple of 16, each of the joined inputs by itself.
  Layer layer;
  layer.in = roundedUp(firstInput) + roundedUp(secondInput);
  layer.out = roundedUp(w.shape[0]);
  constexpr std::size_t kTaps = 9;
  std::vector<float> padded(static_cast<std::size_t>(layer.in * layer.out) * kTaps);
  for (int o = 0; o < w.shape[0]; ++o) {
    for (int i = 0; i < w.shape[1]; ++i) {
      const int to = i < firstInput ? i : roundedUp(firstInput) + i - firstInput;
      std::copy_n(w.values.begin() + (o * w.shape[1] + i) * static_cast<int>(kTaps), kTaps,
                  padded.begin() + (o * layer.in + to) * static_cast<int>(kTaps));
    }
  }
  std::vector<float> biases(static_cast<std::size_t>(layer.out));
  std::ranges::copy(bias->second.values, biases.begin());

  using Memory = dnnl::memory;
  const auto keep = [&](const std::vector<float>& values, const Memory::dims& dims, Memory::format_tag tag) {
    Memory memory({dims, Memory::data_type::f32, tag}, engine);
    std::memcpy(memory.get_data_handle(), values.data(), values.size() * sizeof(float));
    return memory;
  };
  layer.weights = keep(padded, {layer.out, layer.in, 3, 3}, Memory::format_tag::oihw);
  layer.bias = keep(biases, {layer.out}, Memory::format_tag::x);
  return layer;
}

// Rows that take some milliseconds.
int DenoiseNetwork::Impl::stripRows(const Layer& layer, const Map& from) {
  constexpr double kProducts = 4e8;
  return std::clamp(static_cast<int>(kProducts / (9.0 * layer.in * layer.out * from.width)), 8, from.height);
}

// 3 x 3 with ReLU. The last one writes floats: bfloat16 would show as bands.
Map DenoiseNetwork::Impl::convolve(const std::string& name, const Map& from, bool last) {
  using Memory = dnnl::memory;
  Layer& layer = layers.at(name);
  const auto type = format.bf16 ? Memory::data_type::bf16 : Memory::data_type::f32;
  const auto outType = last ? Memory::data_type::f32 : type;
  const auto tag = format.blocked ? Memory::format_tag::nChw16c : Memory::format_tag::nhwc;
  Map to(layer.out, from.width, from.height, {format.bf16 && !last, format.blocked}, pool);

  dnnl::post_ops relu;
  relu.append_eltwise(1, dnnl::algorithm::eltwise_relu, 0, 0);
  dnnl::primitive_attr attributes;
  attributes.set_post_ops(relu);
  const Memory::desc anyWeights({layer.out, layer.in, 3, 3}, type, Memory::format_tag::any);
  // In strips, so that whoever gives up does not wait for a whole layer. Blocks of channels lie apart.
  const int rows = format.blocked ? from.height : stripRows(layer, from);
  const std::size_t sourceRow = std::size_t(from.width) * std::size_t(layer.in) * format.bytes();
  const std::size_t targetRow = std::size_t(from.width) * std::size_t(layer.out) *
                                (last ? sizeof(float) : static_cast<std::size_t>(format.bytes()));
  for (int y = 0; y < from.height; y += rows) {
    if (progress) progress->check();
    const int end = std::min(y + rows, from.height);
    const int above = y > 0, below = end < from.height;  // rows of the neighbours, instead of zeros
    const Memory::desc source({1, layer.in, above + end - y + below, from.width}, type, tag);
    const Memory::desc target({1, layer.out, end - y, from.width}, outType, tag);
    const dnnl::convolution_forward::primitive_desc description({dnnl::prop_kind::forward_inference,
                                                                 dnnl::algorithm::convolution_direct,
                                                                 source,
                                                                 anyWeights,
                                                                 layer.bias.get_desc(),
                                                                 target,
                                                                 {1, 1},
                                                                 {1 - above, 1},
                                                                 {1 - below, 1}},
                                                                attributes, engine);
    if (layer.weights.get_desc() != description.weights_desc()) {
      Memory reordered(description.weights_desc(), engine);
      dnnl::reorder(layer.weights, reordered).execute(stream, layer.weights, reordered);
      stream.wait();
      layer.weights = reordered;
    }
    if (implementation.empty()) implementation = description.impl_info_str();
    std::byte* input = const_cast<std::byte*>(from.data()) + static_cast<std::size_t>(y - above) * sourceRow;
    std::byte* output = to.data() + static_cast<std::size_t>(y) * targetRow;
    dnnl::convolution_forward(description)
        .execute(stream, {{DNNL_ARG_SRC, Memory(source, engine, input)},
                          {DNNL_ARG_WEIGHTS, layer.weights},
                          {DNNL_ARG_BIAS, layer.bias},
                          {DNNL_ARG_DST, Memory(target, engine, output)}});
    stream.wait();
  }
  return to;
}

Map DenoiseNetwork::Impl::runOn(const Map& input) {
  const Map half = halve(convolve("enc_conv1", convolve("enc_conv0", input)));
  const Map quarter = halve(convolve("enc_conv2", half));
  const Map eighth = halve(convolve("enc_conv3", quarter));
  Map x = halve(convolve("enc_conv4", eighth));
  x = convolve("enc_conv5b", convolve("enc_conv5a", x));
  x = convolve("dec_conv4b", convolve("dec_conv4a", join(x, eighth)));
  x = convolve("dec_conv3b", convolve("dec_conv3a", join(x, quarter)));
  x = convolve("dec_conv2b", convolve("dec_conv2a", join(x, half)));
  x = convolve("dec_conv1b", convolve("dec_conv1a", join(x, input)));
  return convolve("dec_conv0", x, true);
}

DenoiseNetwork::DenoiseNetwork(bool fast) {
  try {
    impl_ = std::make_unique<Impl>(fast, bestFormat());
  } catch (const dnnl::error& error) {
    throw RenderError(std::string("the denoiser's network cannot be set up: ") + error.what());
  }
}
DenoiseNetwork::~DenoiseNetwork() = default;

bool DenoiseNetwork::available(bool fast) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(weightPath(fast), ignored);
}

const std::string& DenoiseNetwork::implementation() const { return impl_->implementation; }

namespace {

// The factor that brings the picture to the brightness the networks were trained at: the log-mean over bins
// of about 16 pixels, so that noise does not weigh in, becomes 0.18.
float networkExposure(const std::vector<Rgb>& color, int width, int height) {
  constexpr int kBin = 16;
  const int nx = (width + kBin - 1) / kBin, ny = (height + kBin - 1) / kBin;
  double sum = 0;
  int count = 0;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int x0 = i * width / nx, x1 = (i + 1) * width / nx, y0 = j * height / ny,
                y1 = (j + 1) * height / ny;
      double bin = 0;
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          bin += static_cast<double>(luminance(color[static_cast<std::size_t>(y * width + x)]));
        }
      }
      bin /= std::max((x1 - x0) * (y1 - y0), 1);
      if (bin > 1e-8) {
        sum += std::log2(bin);
        ++count;
      }
    }
  }
  return count > 0 ? static_cast<float>(0.18 / std::exp2(sum / count)) : 1.0f;
}

float unit(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }
float signedUnit(float v) { return v > -1 ? std::min(v, 1.0f) : -1.0f; }

// The span of tile i of n along a side: what it computes, and within that what it keeps.
struct Span {
  int from, to, keepFrom, keepTo;
};
std::vector<Span> tileSpans(int side) {
  if (side <= kTile) return {{0, side, 0, side}};
  const int inner = kTile - 2 * kTileMargin;
  const int n = (side + inner - 1) / inner;
  std::vector<Span> spans;
  for (int i = 0; i < n; ++i) {
    // Cut at multiples of 16, so that the pooling grid is the same in every tile.
    const auto cut = [&](int k) {
      return k == n ? side : static_cast<int>(static_cast<long>(side) * k / n) / kBlock * kBlock;
    };
    spans.push_back(
        {std::max(cut(i) - kTileMargin, 0), std::min(cut(i + 1) + kTileMargin, side), cut(i), cut(i + 1)});
  }
  // All of one size, since what is set up for one size (memory, the library's primitives) serves all.
  int size = 0;
  for (const Span& s : spans) size = std::max(size, roundedUp(s.to - s.from));
  for (Span& s : spans) {
    s.to = std::min(s.from + size, side);
    if (s.to == side) s.from = roundedUp(side - size);
  }
  return spans;
}

}  // namespace

void DenoiseNetwork::run(const Film& film, std::vector<Rgb>& color, int threads, const Progress* progress) {
  impl_->progress = progress;
  const ThreadCount threadCount(threads);
  const TransferCurve& curve = impl_->curve;
  const Format format = impl_->format;
  const float exposure = networkExposure(color, film.width, film.height);

  const auto fill = [&](Map& map, const Span& sx, const Span& sy) {
    forRows(sy.to - sy.from, [&](int y) {
      for (int x = 0; x < sx.to - sx.from; ++x) {
        const std::size_t i = film.index(sx.from + x, sy.from + y);
        const Rgb c = color[i] * exposure, a = film.meanAlbedo(i);
        const Vec3f n = film.meanNormal(i);
        const float values[9] = {curve.forward(c.x),
                                 curve.forward(c.y),
                                 curve.forward(c.z),
                                 unit(a.x),
                                 unit(a.y),
                                 unit(a.z),
                                 signedUnit(n.x) * 0.5f + 0.5f,
                                 signedUnit(n.y) * 0.5f + 0.5f,
                                 signedUnit(n.z) * 0.5f + 0.5f};
        std::byte* out = map.data() + at(map, format, 0, x, y) * format.bytes();
        for (float v : values) {
          if (format.bf16) {
            const std::uint16_t bits = toBf16(v);
            std::memcpy(out, &bits, 2);
          } else {
            std::memcpy(out, &v, 4);
          }
          out += format.bytes();
        }
      }
    });
  };

  std::vector<Rgb> result(color.size());
  try {
    for (const Span& sy : tileSpans(film.height)) {
      for (const Span& sx : tileSpans(film.width)) {
        Map input(kBlock, roundedUp(sx.to - sx.from), roundedUp(sy.to - sy.from), format, impl_->pool);
        std::memset(input.data(), 0, input.size(format));
        fill(input, sx, sy);
        const Map output = impl_->runOn(input);
        const Format outFormat{false, format.blocked};
        forRows(sy.keepTo - sy.keepFrom, [&](int row) {
          const int y = sy.keepFrom + row;
          for (int x = sx.keepFrom; x < sx.keepTo; ++x) {
            float rgb[3];
            std::memcpy(rgb, output.data() + at(output, outFormat, 0, x - sx.from, y - sy.from) * 4,
                        sizeof rgb);
            result[film.index(x, y)] =
                Rgb{curve.inverse(rgb[0]), curve.inverse(rgb[1]), curve.inverse(rgb[2])} * (1 / exposure);
          }
        });
      }
    }
  } catch (const dnnl::error& error) {
    throw RenderError(std::string("the denoiser's network failed: ") + error.what());
  } catch (const std::bad_alloc&) {
    throw RenderError("not enough memory to denoise the picture");
  }
  color = std::move(result);
}

}  // namespace idap::render
