// The window in a language that is written from right to left. There is no such translation yet, so this one is made up:
// English with Hebrew letters.

#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/listing_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "app/ui/time/timeline_strip.h"
#include "tests/app/language/cut_text.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLineEdit>
#include <QMenuBar>
#include <QScrollBar>
#include <QSlider>
#include <QTranslator>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

/// Writes a text with Hebrew letters. Placeholders, markup, code, links and the letter after & stay.
QString inHebrewLetters(const QString &text)
{
    static const QRegularExpression kept(R"(%L?\d+|%n|&\w+;?|<[^>]*>|`[^`]*`|\]\([^)]*\))");
    QString written = text;
    qsizetype end = 0;
    const auto write = [&](qsizetype from, qsizetype to) {
        for (qsizetype i = from; i < to; ++i) {
            const char16_t letter = text[i].toLower().unicode();
            if (letter >= u'a' && letter <= u'z')
                written[i] = QChar(char16_t(0x05d0 + (letter - u'a')));
        }
    };
    for (auto at = kept.globalMatch(text); at.hasNext();) {
        const QRegularExpressionMatch one = at.next();
        write(end, one.capturedStart());
        end = one.capturedEnd();
    }
    write(end, text.size());
    return written.replace(QStringLiteral("…"), QStringLiteral(" …")); // as German has it
}

/// Translates every text, and says that the language is written from right to left.
class MirroredLanguage : public QTranslator
{
public:
    MirroredLanguage() { QCoreApplication::installTranslator(this); }
    ~MirroredLanguage() override { QCoreApplication::removeTranslator(this); }
    MirroredLanguage(const MirroredLanguage &) = delete;
    MirroredLanguage &operator=(const MirroredLanguage &) = delete;

    bool isEmpty() const override { return false; }
    QString translate(const char *, const char *source, const char *, int) const override
    {
        const QString text = QString::fromUtf8(source);
        return text == "QT_LAYOUT_DIRECTION" ? QStringLiteral("RTL") : inHebrewLetters(text);
    }
};

int leftEdgeIn(const QWidget &part, const QWidget &window)
{
    return part.mapTo(&window, QPoint(0, 0)).x();
}

}

class RightToLeftTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QVERIFY(QGuiApplication::isLeftToRight());
        m_language = std::make_unique<MirroredLanguage>();
        QVERIFY(QGuiApplication::isRightToLeft());
    }
    void cleanup() { m_language.reset(); }

    void menusAndRowsBeginOnTheRight();
    void timeAndPictureAreNotMirrored();
    void codeBeginsOnTheLeft();
    void nothingIsCut_data();
    void nothingIsCut();

private:
    std::unique_ptr<MirroredLanguage> m_language;
};

void RightToLeftTest::menusAndRowsBeginOnTheRight()
{
    WindowFixture window({.codePage = "listing"});
    const QMenuBar &menus = window.part<QMenuBar>();
    QCOMPARE(menus.actions().first()->text(), inHebrewLetters("&File"));
    QVERIFY(menus.actionGeometry(menus.actions().first()).x() >
            menus.actionGeometry(menus.actions().last()).x());
    auto *row = window.window.findChild<ParameterRow *>();
    QVERIFY(row);
    const auto *slider = row->findChild<QSlider *>();
    const auto *box = row->findChild<QLineEdit *>(); // follows the slider
    QVERIFY(slider && box);
    QVERIFY(leftEdgeIn(*slider, window.window) > leftEdgeIn(*box, window.window));
}

void RightToLeftTest::timeAndPictureAreNotMirrored()
{
    WindowFixture window;
    QVERIFY(window.onScreen("foot").x() != window.onScreen("body").x());
    const int foot = window.session.timeline().track().interval().scene.find("foot");
    const int body = window.session.timeline().track().interval().scene.find("body");
    const sim::State &state = window.session.timeline().state();
    QCOMPARE(window.onScreen("foot").x() > window.onScreen("body").x(),
             state.positionOf(foot).x > state.positionOf(body).x);

    window.goTo(100);
    TimelineStrip &strip = window.part<TimelineStrip>();
    const auto frameAt = [&](double share) {
        QTest::mouseClick(&strip, Qt::LeftButton, {}, {int(strip.width() * share), 8});
        window.arrives();
        return window.frame();
    };
    const std::int64_t early = frameAt(0.3), late = frameAt(0.6);
    QVERIFY2(early < late, qPrintable(QString("%1 %2").arg(early).arg(late)));
    const std::int64_t before = window.frame();
    window.key(Qt::Key_Right);
    QCOMPARE(window.frame(), before + 1);
    window.key(Qt::Key_Left);
    QCOMPARE(window.frame(), before);
}

void RightToLeftTest::codeBeginsOnTheLeft()
{
    WindowFixture window({.codePage = "listing"});
    const ListingEditor &editor = window.part<ListingPanel>().editor();
    QVERIFY(editor.isVisible());
    QCOMPARE(editor.layoutDirection(), Qt::LeftToRight);
    QVERIFY(leftEdgeIn(*editor.verticalScrollBar(), editor) > editor.width() / 2);
}

void RightToLeftTest::nothingIsCut_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<bool>("measuring");
    for (const bool measuring : {false, true}) {
        for (const char *step :
             {"single_spring/radial", "walking_gait/ground", "swaying_tree/wind", "accuracy/halve"})
            QTest::addRow("%s, %s", step, measuring ? "measure" : "learn")
                << QString(step).section('/', 0, 0) << QString(step).section('/', 1) << measuring;
    }
}

void RightToLeftTest::nothingIsCut()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(bool, measuring);
    WindowFixture window({.lesson = lesson, .step = step, .study = quickStudy, .codePage = "listing"});
    window.window.setMode(measuring ? MainWindow::Mode::measure : MainWindow::Mode::learn);
    window.window.docks().show(Panel::energy, measuring);
    window.window.docks().show(Panel::effects, measuring);
    window.session.playback().goTo({3, 1});
    settle();
    if (measuring) {
        QTRY_COMPARE(window.window.study().stage(), AccuracyStudy::Stage::done);
        settle();
    }
    const QStringList cut = cutIn(window.window);
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

SUITE(tst_right_to_left, RightToLeftTest)
#include "tst_right_to_left.moc"
