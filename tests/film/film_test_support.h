// Homes with a walk in them, and films read back.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <unistd.h>
#include <filesystem>
#include <string>

#include "model/home.h"

namespace idap::test {

inline Wall wallBetween(Vec2 a, Vec2 b) {
  Wall wall;
  wall.start = a;
  wall.end = b;
  wall.thickness = 0.1;
  return wall;
}

inline Camera eyeAt(double x, double y, double yaw = 0) {
  Camera camera;
  camera.eye = {x, y, 1.6};
  camera.yaw = yaw;
  return camera;
}

// Two rooms of 4 x 4 m, one at x 0..4, the other at x 4..8, and a door between them at (4, 3).
inline Home twoRooms(bool withDoor = true) {
  Home home;
  const auto wall = [&](Vec2 a, Vec2 b) { home.walls.set(home.newId<WallId>(), wallBetween(a, b)); };
  wall({0, 0}, {8, 0}), wall({8, 0}, {8, 4}), wall({8, 4}, {0, 4}), wall({0, 4}, {0, 0}),
      wall({4, 0}, {4, 4});
  for (const double x : {0.0, 4.0}) {
    Room room;
    room.points = {{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}};
    home.rooms.set(home.newId<RoomId>(), room);
  }
  if (withDoor) {
    Opening door;
    door.position = {4, 3, 0};
    door.angle = kPi / 2;
    door.size = {0.9, 0.15, 2.1};
    door.model.catalogId = "idap/door-flush";
    home.openings.set(home.newId<OpeningId>(), door);
  }
  return home;
}

inline FurnitureId addTable(Home& home, Vec2 middle, Vec2 size, double height = 0.75) {
  Furniture table;
  table.model.catalogId = "idap/table-dining";
  table.position = {middle.x, middle.y, 0};
  table.size = {size.x, size.y, height};
  const auto id = home.newId<FurnitureId>();
  home.furniture.set(id, table);
  return id;
}

// A folder of its own for a test, gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "idap-film-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t files() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
    return count;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct FilmFile {
  int width = 0, height = 0, frames = 0;
  double seconds = 0, framesPerSecond = 0;
  std::string codec;
  bool bt709 = false, everyFrameAsLong = true;
};

inline FilmFile readFilm(const std::filesystem::path& file) {
  FilmFile film;
  AVFormatContext* format = nullptr;
  if (avformat_open_input(&format, file.c_str(), nullptr, nullptr) < 0) return film;
  avformat_find_stream_info(format, nullptr);
  const AVStream* stream = format->streams[0];
  film.width = stream->codecpar->width;
  film.height = stream->codecpar->height;
  film.codec = avcodec_get_name(stream->codecpar->codec_id);
  film.bt709 = stream->codecpar->color_space == AVCOL_SPC_BT709 &&
               stream->codecpar->color_primaries == AVCOL_PRI_BT709;
  film.framesPerSecond = av_q2d(stream->avg_frame_rate);
  film.seconds = static_cast<double>(format->duration) / AV_TIME_BASE;
  AVPacket* packet = av_packet_alloc();
  while (av_read_frame(format, packet) >= 0) {
    ++film.frames;
    film.everyFrameAsLong &=
        std::abs(static_cast<double>(packet->duration) * av_q2d(stream->time_base) * film.framesPerSecond -
                 1) < 1e-6;
    av_packet_unref(packet);
  }
  av_packet_free(&packet);
  avformat_close_input(&format);
  return film;
}

}  // namespace idap::test
