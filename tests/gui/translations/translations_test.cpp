// Every text of the studio is there in every language, and says it in the same form.
#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>

#include "studio/widgets/texts.h"

namespace idap {
namespace {

struct Message {
  QString context, source, translation;
  bool unfinished = false, plural = false;
};

std::vector<Message> messagesOf(const QString& file) {
  QFile ts(file);
  EXPECT_TRUE(ts.open(QIODevice::ReadOnly)) << fromQt(file);
  QXmlStreamReader xml(&ts);
  std::vector<Message> out;
  QString context;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("message")) {
      out.push_back({.context = context});
      out.back().plural = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    }
    if (xml.name() == QLatin1String("source")) out.back().source = xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      out.back().unfinished = xml.attributes().value(QLatin1String("type")) == QLatin1String("unfinished");
      out.back().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    }
  }
  EXPECT_FALSE(xml.hasError()) << fromQt(xml.errorString());
  return out;
}

QStringList placesOf(const QString& text) {
  static const QRegularExpression place(QStringLiteral("%L?[0-9n]"));
  QStringList places;
  for (auto it = place.globalMatch(text); it.hasNext();) places << it.next().captured();
  places.sort();
  return places;
}

// The letter behind a single &, in lower case; null where there is none.
QChar keyOf(const QString& text) {
  for (qsizetype i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != QLatin1Char('&')) continue;
    if (text[i + 1].isLetterOrNumber()) return text[i + 1].toLower();
    ++i;
  }
  return {};
}

class Translations : public testing::Test {
 protected:
  Translations() : all(messagesOf(QStringLiteral(IDAP_SOURCE_DIR "/share/translations/idap_th.ts"))) {}
  std::vector<Message> all;
};

TEST_F(Translations, NothingIsLeftToTranslate) {
  EXPECT_GT(all.size(), 1000u);
  for (const Message& m : all)
    EXPECT_FALSE(m.unfinished || m.translation.trimmed().isEmpty())
        << fromQt(m.context + QStringLiteral(": ") + m.source);
}

// English has no translation file, so it would show plurals as "1 pieces".
TEST_F(Translations, NoTextNeedsPluralForms) {
  for (const Message& m : all) EXPECT_FALSE(m.plural) << fromQt(m.context + QStringLiteral(": ") + m.source);
}

TEST_F(Translations, KeepPlacesForValuesAndKeys) {
  for (const Message& m : all) {
    EXPECT_EQ(placesOf(m.source), placesOf(m.translation)) << fromQt(m.source);
    EXPECT_EQ(keyOf(m.source), keyOf(m.translation)) << fromQt(m.source) << " / " << fromQt(m.translation);
    EXPECT_EQ(m.source.endsWith(QChar(0x2026)), m.translation.endsWith(QChar(0x2026))) << fromQt(m.source);
    EXPECT_EQ(m.translation, m.translation.trimmed()) << fromQt(m.source);
  }
}

TEST_F(Translations, TheSourcesHaveNoTextThatIsNotInThem) {
  const QString script = QStringLiteral(IDAP_SOURCE_DIR "/dev/translate");
  QProcess run;
  run.setProcessChannelMode(QProcess::MergedChannels);
  run.start(script, {QStringLiteral("--check")});
  ASSERT_TRUE(run.waitForFinished(120'000));
  const std::string said = run.readAll().toStdString();
  if (said.find("lupdate: ") != std::string::npos) GTEST_SKIP() << "Qt's lupdate is not installed";
  EXPECT_EQ(run.exitCode(), 0) << said;
  // A class without Q_OBJECT is asked for by its base's name, and its texts are not found then.
  EXPECT_THAT(said, testing::Not(testing::HasSubstr("lacks Q_OBJECT")));
}

TEST_F(Translations, AreInTheProgram) {
  QTranslator thai;
  ASSERT_TRUE(thai.load(QStringLiteral(":/translations/idap_th.qm")));
  QCoreApplication::installTranslator(&thai);
  EXPECT_EQ(translated("Undo"), QStringLiteral("เลิกทำ"));
  int shown = 0;
  for (const Message& m : all)
    shown += QCoreApplication::translate(m.context.toUtf8(), m.source.toUtf8()) != m.source;
  QCoreApplication::removeTranslator(&thai);
  EXPECT_GT(shown, int(all.size()) * 95 / 100);
  EXPECT_EQ(translated("Undo"), QStringLiteral("Undo"));
}

}  // namespace
}  // namespace idap
