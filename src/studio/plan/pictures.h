// Pictures that plans use: scans under the drawing, decoded in the background, and the mean colour of
// textures. Belongs to the GUI thread; changed() tells that something came.
#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <map>
#include <memory>
#include <optional>

#include "base/bytes.h"
#include "model/finish.h"
#include "model/home.h"

namespace idap {

class Pictures : public QObject {
  Q_OBJECT
 public:
  // One for all views of the program.
  static std::shared_ptr<Pictures> shared();
  ~Pictures() override;

  // The decoded picture; null until it is there, or for ever when it cannot be read.
  QImage picture(const SharedBytes& bytes);
  // How a face with this finish looks on the whole; nothing for an empty finish, and until it is known.
  std::optional<Color> colorOf(const Home& home, const Finish& finish);

  // The mean colour of an encoded picture, computed at once. Any thread.
  static std::optional<Color> meanColor(const Bytes& bytes);

 signals:
  void changed();

 private:
  struct Entry;
  Pictures();
  Entry& entryOf(const SharedBytes& bytes, bool whole);
  std::map<const Bytes*, std::shared_ptr<Entry>> entries_;
  std::map<std::string, std::optional<Color>> materials_;
  QThreadPool pool_;
};

}  // namespace idap
