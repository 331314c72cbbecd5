#include "film/video_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include "base/error.h"
#include "base/file.h"

namespace idap {

namespace fs = std::filesystem;

namespace {

constexpr int kTicks = 1200;  // of the file's clock, a frame

std::string words(int code) {
  char text[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, text, sizeof text);
  return text;
}

// An unused name beside the target, where a rename can put it into its place.
std::string nameBeside(const fs::path& target) {
  std::string name = target.string() + ".XXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) throw IoError(target.string() + ": cannot write: " + std::strerror(errno));
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(file, 0666 & ~mask) != 0) {
    // The film is readable by its maker alone then, which is no reason to have none.
  }
  ::close(file);
  return name;
}

}  // namespace

struct VideoWriter::Impl {
  fs::path file, target;
  std::string temporary, remark;
  int width, height, pictureWidth, pictureHeight;
  AVFormatContext* format = nullptr;
  AVCodecContext* codec = nullptr;
  AVStream* stream = nullptr;
  AVFrame* frame = nullptr;
  AVPacket* packet = nullptr;
  SwsContext* scaler = nullptr;
  std::int64_t frames = 0;
  bool finished = false;

  Impl(const fs::path& path, int w, int h, int rate)
      : file(path), width(w / 2 * 2), height(h / 2 * 2), pictureWidth(w), pictureHeight(h) {
    if (width < 16 || height < 16 || width > 8192 || height > 8192)
      throw IoError(
          fmt::format("{}: a film is from 16 x 16 to 8192 x 8192 pixels, not {} x {}", file.string(), w, h));
    if (rate < 1 || rate > 240)
      throw IoError(fmt::format("{}: a film has from 1 to 240 frames a second, not {}", file.string(), rate));
    av_log_set_level(AV_LOG_QUIET);  // errors are told in our words
    std::error_code ignored;
    target = fs::weakly_canonical(file, ignored);
    if (target.empty()) target = file;

    requireWritable(target);
    temporary = nameBeside(target);
    try {
      open(rate);
    } catch (...) {
      close();
      throw;
    }
  }

  ~Impl() { close(); }

  [[noreturn]] void fail(const char* what, int code) const {
    throw IoError(fmt::format("{}: cannot {}: {}", file.string(), what,
                              code == AVERROR(ENOSPC) ? "no space left on the disk" : words(code)));
  }
  void check(int code, const char* what) const {
    if (code < 0) fail(what, code);
  }

  void open(int rate) {
    check(avformat_alloc_output_context2(&format, nullptr, "mp4", temporary.c_str()), "make an MP4 file");
    const AVCodec* encoder = avcodec_find_encoder_by_name("libx264");
    if (!encoder) {
      encoder = avcodec_find_encoder(AV_CODEC_ID_MPEG4);
      remark =
          "FFmpeg has no H.264 encoder (libx264) here; the film is MPEG-4 part 2, larger and not shown by "
          "browsers";
    }
    if (!encoder)
      throw IoError(file.string() +
                    ": cannot make a film: FFmpeg has no video encoder here; install libx264");
    codec = avcodec_alloc_context3(encoder);
    stream = avformat_new_stream(format, nullptr);
    frame = av_frame_alloc();
    packet = av_packet_alloc();
    if (!codec || !stream || !frame || !packet) fail("make a film", AVERROR(ENOMEM));
    codec->width = width;
    codec->height = height;
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->time_base = {1, rate};
    codec->framerate = {rate, 1};
    codec->gop_size = 2 * rate;
    codec->color_primaries = AVCOL_PRI_BT709;
    codec->color_trc = AVCOL_TRC_BT709;
    codec->colorspace = AVCOL_SPC_BT709;
    codec->color_range = AVCOL_RANGE_MPEG;
    codec->sample_aspect_ratio = {1, 1};
    if (format->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (encoder->id == AV_CODEC_ID_H264) {
      av_opt_set(codec->priv_data, "preset", "medium", 0);
      av_opt_set(codec->priv_data, "crf", "18", 0);
      // Smooth walls in shade keep their gradients.
      av_opt_set(codec->priv_data, "aq-mode", "3", 0);
    } else {
      codec->bit_rate = static_cast<std::int64_t>(width) * height * rate / 4;
    }
    check(avcodec_open2(codec, encoder, nullptr), "start the video encoder");
    check(avcodec_parameters_from_context(stream->codecpar, codec), "start the video encoder");
    stream->time_base = {1, rate * kTicks};
    stream->avg_frame_rate = {rate, 1};
    stream->sample_aspect_ratio = {1, 1};
    frame->format = codec->pix_fmt;
    frame->width = width;
    frame->height = height;
    frame->color_range = codec->color_range;
    frame->colorspace = codec->colorspace;
    frame->color_primaries = codec->color_primaries;
    frame->color_trc = codec->color_trc;
    check(av_frame_get_buffer(frame, 0), "make a film");
    scaler = sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, AV_PIX_FMT_YUV420P,
                            SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr, nullptr);
    if (!scaler) fail("make a film", AVERROR(ENOMEM));
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler, bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
    check(avio_open(&format->pb, temporary.c_str(), AVIO_FLAG_WRITE), "write");
    AVDictionary* options = nullptr;
    av_dict_set(&options, "movflags", "+faststart", 0);
    const int begun = avformat_write_header(format, &options);
    av_dict_free(&options);
    check(begun, "write");
  }

  void encode(const AVFrame* of) {
    check(avcodec_send_frame(codec, of), "encode a frame");
    for (;;) {
      const int got = avcodec_receive_packet(codec, packet);
      if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return;
      check(got, "encode a frame");
      packet->stream_index = stream->index;
      packet->duration = 1;
      av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
      const int written = av_interleaved_write_frame(format, packet);
      check(written, "write");
      check(format->pb->error, "write");
    }
  }

  void add(const Image8& picture) {
    if (picture.width != pictureWidth || picture.height != pictureHeight)
      throw IoError(fmt::format("{}: a picture of {} x {} in a film of {} x {}", file.string(), picture.width,
                                picture.height, pictureWidth, pictureHeight));
    check(av_frame_make_writable(frame), "make a frame");
    const std::uint8_t* rows[] = {picture.rgb.data()};
    const int strides[] = {3 * picture.width};
    sws_scale(scaler, rows, strides, 0, height, frame->data, frame->linesize);
    frame->pts = frames++;
    encode(frame);
  }

  void finish() {
    if (frames == 0) throw IoError(file.string() + ": a film needs a frame");
    encode(nullptr);
    check(av_write_trailer(format), "write");
    const int closed = avio_closep(&format->pb);
    check(closed, "write");
    const int made = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
    if (made >= 0) {
      const bool safe = ::fsync(made) == 0 || errno == EINVAL;
      const int reason = errno;
      ::close(made);
      if (!safe) fail("write", AVERROR(reason));
    }
    if (::rename(temporary.c_str(), target.c_str()) != 0) fail("write", AVERROR(errno));
    finished = true;
    close();
  }

  void close() {
    sws_freeContext(std::exchange(scaler, nullptr));
    av_packet_free(&packet);
    av_frame_free(&frame);
    avcodec_free_context(&codec);
    if (format && format->pb) avio_closep(&format->pb);
    avformat_free_context(std::exchange(format, nullptr));
    if (!finished && !temporary.empty()) ::unlink(temporary.c_str());
  }
};

VideoWriter::VideoWriter(const fs::path& file, int width, int height, int framesPerSecond)
    : impl_(std::make_unique<Impl>(file, width, height, framesPerSecond)) {}
VideoWriter::~VideoWriter() = default;
void VideoWriter::add(const Image8& picture) { impl_->add(picture); }
int VideoWriter::frames() const { return static_cast<int>(impl_->frames); }
void VideoWriter::finish() { impl_->finish(); }
const std::string& VideoWriter::remark() const { return impl_->remark; }

}  // namespace idap
