#include "studio/window/dialogs/site_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDateTimeEdit>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QTimeZone>
#include <cmath>
#include <numbers>

#include "studio/widgets/number_field.h"
#include "studio/widgets/texts.h"
#include "studio/window/dialogs/cities.h"
#include "studio/window/dialogs/compass_face.h"

namespace idap {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

double turnedPositive(double degrees) {
  degrees = std::fmod(degrees, 360);
  return degrees < 0 ? degrees + 360 : degrees;
}

}  // namespace

SiteDialog::SiteDialog(Editor& editor, QWidget* parent)
    : FormDialog("siteDialog", parent),
      editor_(editor),
      city_(new QComboBox(this)),
      zone_(new QComboBox(this)),
      latitude_(new NumberField(this, QStringLiteral("°"), 4)),
      longitude_(new NumberField(this, QStringLiteral("°"), 4)),
      north_(new NumberField(this, QStringLiteral("°"), 2)),
      time_(new QDateTimeEdit(this)),
      shown_(new QCheckBox(this)),
      face_(new CompassFace(this)) {
  const Site& site = editor.home().site;
  city_->setObjectName(QStringLiteral("city"));
  zone_->setObjectName(QStringLiteral("timeZone"));
  latitude_->setObjectName(QStringLiteral("latitude"));
  longitude_->setObjectName(QStringLiteral("longitude"));
  north_->setObjectName(QStringLiteral("north"));
  time_->setObjectName(QStringLiteral("time"));
  shown_->setObjectName(QStringLiteral("compassShown"));
  for (QComboBox* box : {city_, zone_}) {
    // Typing finds it, in the middle of the name too.
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->completer()->setCompletionMode(QCompleter::PopupCompletion);
    box->completer()->setFilterMode(Qt::MatchContains);
    box->setMaxVisibleItems(16);
  }
  latitude_->setRange(-90, 90);
  longitude_->setRange(-180, 180);
  north_->setRange(-360, 360);
  for (const QByteArray& id : QTimeZone::availableTimeZoneIds()) zone_->addItem(QString::fromLatin1(id));
  latitude_->setValue(site.latitude / kDegree);
  longitude_->setValue(site.longitude / kDegree);
  // People read a compass clockwise.
  north_->setValue(turnedPositive(-site.north / kDegree));
  face_->setNorth(north_->value());
  zone_->setCurrentText(toQt(site.timeZone));
  time_->setDisplayFormat(QStringLiteral("yyyy-MM-dd  HH:mm"));
  time_->setCalendarPopup(true);
  showTime(site.time);
  shown_->setChecked(site.compassVisible);

  cityLabel_ = addRow(city_);
  latitudeLabel_ = addRow(latitude_);
  longitudeLabel_ = addRow(longitude_);
  zoneLabel_ = addRow(zone_);
  timeLabel_ = addRow(time_);
  northLabel_ = addRow(north_);
  form()->addRow(QString(), face_);
  form()->addRow(shown_);

  connect(city_, &QComboBox::activated, this, &SiteDialog::chooseCity);
  for (NumberField* field : {latitude_, longitude_})
    connect(field, &ValueField::valueChanged, this, &SiteDialog::findCity);
  connect(north_, &ValueField::valueChanged, face_, &CompassFace::setNorth);
  connect(north_, &ValueField::valueTyped, face_, &CompassFace::setNorth);
  connect(face_, &CompassFace::turned, north_, &NumberField::setValue);
  retranslate();
}

void SiteDialog::retranslate() {
  setWindowTitle(tr("Compass and place"));
  cityLabel_->setText(tr("&Town"));
  latitudeLabel_->setText(tr("&Latitude"));
  longitudeLabel_->setText(tr("L&ongitude"));
  zoneLabel_->setText(tr("Time &zone"));
  timeLabel_->setText(tr("&Date and hour"));
  northLabel_->setText(tr("&North"));
  shown_->setText(tr("Show the &compass on the plan"));
  city_->setToolTip(tr("Sets place and time zone; type to find it"));
  latitude_->setToolTip(tr("North of the equator positive"));
  longitude_->setToolTip(tr("East of Greenwich positive"));
  time_->setToolTip(tr("The home's own time: where the sun stands in its pictures"));
  north_->setToolTip(tr("Clockwise from up the page; the rose can be turned by hand"));
  city_->clear();
  city_->addItem(tr("(another place)"));
  for (const City& city : cities()) city_->addItem(QCoreApplication::translate("cities", city.name));
  findCity();
}

void SiteDialog::chooseCity(int index) {
  if (index <= 0 || index > int(cities().size())) return;
  const City& city = cities()[std::size_t(index - 1)];
  latitude_->setValue(city.latitude);
  longitude_->setValue(city.longitude);
  zone_->setCurrentText(QLatin1String(city.timeZone));
}

void SiteDialog::findCity() {
  int found = 0;
  for (std::size_t i = 0; i < cities().size(); ++i)
    if (std::abs(cities()[i].latitude - latitude_->value()) < 0.03 &&
        std::abs(cities()[i].longitude - longitude_->value()) < 0.03)
      found = int(i) + 1;
  city_->setCurrentIndex(found);
}

void SiteDialog::showTime(std::int64_t time) {
  const QTimeZone zone(zone_->currentText().toLatin1());
  const QDateTime there = zone.isValid() ? QDateTime::fromMSecsSinceEpoch(time, zone)
                                         : QDateTime::fromMSecsSinceEpoch(time, Qt::UTC);
  // The edit shows hours and minutes as they are there, whatever the zone of this machine.
  time_->setTimeSpec(Qt::UTC);
  time_->setDateTime(QDateTime(there.date(), there.time(), Qt::UTC));
}

std::int64_t SiteDialog::time() const {
  const QTimeZone zone(zone_->currentText().toLatin1());
  const QDateTime shown = time_->dateTime();
  if (!zone.isValid()) return QDateTime(shown.date(), shown.time(), Qt::UTC).toMSecsSinceEpoch();
  return QDateTime(shown.date(), shown.time(), zone).toMSecsSinceEpoch();
}

bool SiteDialog::apply() {
  const QByteArray zone = zone_->currentText().trimmed().toLatin1();
  if (!QTimeZone(zone).isValid()) {
    zone_->setFocus();
    zone_->lineEdit()->selectAll();
    return false;
  }
  const Site& before = editor_.home().site;
  Site site = before;
  // Numbers that nobody touched keep what they had beyond the shown decimals.
  const auto take = [](double& value, double shown, double scale) {
    if (std::abs(value / scale - shown) > 5e-5) value = shown * scale;
  };
  take(site.latitude, latitude_->value(), kDegree);
  take(site.longitude, longitude_->value(), kDegree);
  if (std::abs(turnedPositive(-site.north / kDegree) - north_->value()) > 5e-3)
    site.north = -north_->value() * kDegree;
  site.timeZone = zone.toStdString();
  const std::int64_t chosen = time();
  if (site.timeZone != before.timeZone || std::abs(chosen - before.time) >= 60'000) site.time = chosen;
  site.compassVisible = shown_->isChecked();
  return editor_.apply(QT_TRANSLATE_NOOP("idap", "Compass and place"), [&site](const Home& home) {
    Home changed = home;
    changed.site = site;
    return changed;
  });
}

}  // namespace idap
