// The catalog pieces that the user likes or has used lately, by id, kept between sessions.
#pragma once

#include <QObject>
#include <QStringList>

namespace idap {

class Favourites : public QObject {
  Q_OBJECT
 public:
  explicit Favourites(QObject* parent = nullptr);

  static constexpr qsizetype kRecent = 24;

  const QStringList& liked() const { return liked_; }    // the last first
  const QStringList& recent() const { return recent_; }  // the last first
  bool isLiked(const QString& id) const { return liked_.contains(id); }
  void setLiked(const QString& id, bool liked);
  void addRecent(const QString& id);

 signals:
  void changed();

 private:
  QStringList liked_, recent_;
};

}  // namespace idap
