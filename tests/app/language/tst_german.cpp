// The window in German: nothing is cut.

#include "app/ui/help/help_page.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/status/status_figures.h"
#include "app/ui/status/status_sentence.h"
#include "app/ui/window/tour.h"
#include "tests/app/language/drawn_text.h"
#include "tests/app/language/german_support.h"
#include "tests/suite.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStyleOptionComboBox>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

/// Who `widget` is, for a message.
QString whereIs(const QWidget *widget)
{
    QStringList path;
    for (; widget; widget = widget->parentWidget())
        path.prepend(QString(widget->metaObject()->className()).remove("app::"));
    return path.join('/');
}

/// How many px of it are out of sight on its right or left, where nothing can be scrolled to.
int hidden(const QWidget &widget)
{
    return widget.width() - widget.visibleRegion().boundingRect().width();
}

/// How many px a label or button lacks for its text, across or down; 0 where it has enough.
int lacking(const QWidget &widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(&widget)) {
        if (label->text().isEmpty())
            return 0;
        // 2 px of it are below the letters of the last line.
        return label->wordWrap() ? label->heightForWidth(label->width()) - 2 - label->height()
                                 : label->minimumSizeHint().width() - label->width();
    }
    if (const auto *combo = qobject_cast<const QComboBox *>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(combo);
        const QRect field =
            combo->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo);
        return combo->fontMetrics().horizontalAdvance(combo->currentText()) - field.width();
    }
    const auto *push = qobject_cast<const QPushButton *>(&widget);
    if (push && !push->text().isEmpty()) // its padding counts, too
        return push->minimumSizeHint().width() - push->width();
    if (const auto *button = qobject_cast<const QAbstractButton *>(&widget)) {
        if (button->hasHeightForWidth()) // its text wraps
            return button->heightForWidth(button->width()) - button->height();
        const QRect text = button->fontMetrics().boundingRect({}, Qt::TextShowMnemonic, button->text());
        return std::max(text.width() - button->width(), text.height() - button->height());
    }
    return 0;
}

/// The texts that a widget shows, as they are seen: cut where it cuts them itself. In the picture, the code and the plots
/// labels have the place that is left, and the rest of a value is in its tooltip.
QStringList seenIn(QWidget &widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        return {label->text()};
    const auto *button = qobject_cast<const QAbstractButton *>(&widget);
    if (button && !button->text().isEmpty())
        return {button->text().remove(QRegularExpression("[\\x{A0}\\x{200E}]"))};
    const bool isList = qobject_cast<const QAbstractItemView *>(widget.parentWidget());
    return isList || widget.inherits("app::MeasureRow") ? drawnBy(widget) : QStringList();
}

/// What an ellipsis stands at the end of by right: what goes on ("Messung läuft …"), nothing known yet, and the list of
/// what is not in the scene or folded, which are told in full elsewhere.
bool mayEnd(const QString &text)
{
    return text.endsWith(" …") || text == "…" || text.count(", ") > 1;
}

/// The texts in `window` that have not the room that they need.
QStringList cutIn(QWidget &window)
{
    QStringList cut;
    QList<QWidget *> all = window.findChildren<QWidget *>();
    all << &window;
    for (QWidget *widget : all) {
        if (!widget->isVisible() || widget->visibleRegion().isEmpty())
            continue;
        const bool hasText =
            qobject_cast<const QLabel *>(widget) || qobject_cast<const QAbstractButton *>(widget);
        if (const int px = std::max(lacking(*widget), hasText ? hidden(*widget) : 0); px > 0)
            cut << QString("%1: %2 px").arg(whereIs(widget)).arg(px);
        for (const QString &text : seenIn(*widget)) {
            if (text.endsWith(QChar(0x2026)) && !mayEnd(text))
                cut << QString("%1: \"%2\"").arg(whereIs(widget), text);
        }
    }
    return cut;
}

}

class GermanTest : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsCut_data();
    void nothingIsCut();
    void theReasonsOfStabilityAreNotCut();
    void theGalleriesOfPresetsAreNotCut();
    void thePageOfKeysIsNotSquashed();
    void theCardsOfTheTourAreNotCut();
    void theSandboxIsNotCut();
    void aSentenceTooLongForTheStatusBarEndsInDots();
    void aWindowThatGoesTakesItsOpenGalleryAlong();
    void cleanupTestCase() { m_shown.reset(); }

private:
    std::unique_ptr<GermanWindow> m_shown; ///< for the rows of one size
    QSize m_size;
};

void GermanTest::nothingIsCut_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<bool>("measuring");
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        for (const char *lesson : {"single_spring", "multi_foot", "walking_gait", "swaying_tree",
                                   "rigid_constraint", "codeling", "accuracy", "hard_cases"}) {
            for (const bool measuring : {false, true})
                QTest::addRow("%s, %d px, %s", lesson, size.width(), measuring ? "measure" : "learn")
                    << size << QString(lesson) << measuring;
        }
    }
}

void GermanTest::nothingIsCut()
{
    QFETCH(QSize, size);
    QFETCH(QString, lesson);
    QFETCH(bool, measuring);
    if (!m_shown || m_size != size) {
        m_shown.reset(); // first, as there is one language at a time
        m_shown = std::make_unique<GermanWindow>(size);
        m_size = size;
    }
    GermanWindow &shown = *m_shown;
    shown.window.setMode(measuring ? MainWindow::Mode::measure : MainWindow::Mode::learn);
    QStringList cut;
    const std::vector<lessons::Step> &steps = shown.library.lesson(lesson)->steps;
    for (const lessons::Step &step : steps) {
        if (measuring && &step != &steps.front() && &step != &steps.back())
            continue; // their parameters and narration are seen in learning
        shown.session.openStep(lesson, step.id);
        shown.session.playback().goTo({3, 1});
        shown.window.showEnergy(measuring);
        shown.window.showEffects(measuring);
        settle();
        if (measuring) { // what is measured comes later, and then has to find its place
            QTRY_COMPARE(shown.window.study().stage(), AccuracyStudy::Stage::done);
            settle();
        }
        for (const QString &where : cutIn(shown.window)) {
            if (measuring || !where.contains("StatusFigures"))
                cut << step.id + ' ' + where;
        }
    }
    cut.removeDuplicates();
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void GermanTest::theReasonsOfStabilityAreNotCut()
{
    m_shown.reset();
    GermanWindow german;
    QStringList cut;
    const auto look = [&](const char *what, QWidget *at) {
        settle();
        for (const QString &where : cutIn(*at))
            cut << QString("%1: %2").arg(what, where);
    };
    german.session.openStep("multi_foot", "any_number");
    german.window.showStability(true);
    look("stability", &german.window);
    for (const MapPlane plane : {MapPlane::step, MapPlane::damping}) {
        german.window.showGrowthMap(plane);
        look(plane == MapPlane::step ? "map of steps" : "map of damping", &german.window);
    }
    german.window.showSettlingMap(true);
    look("map of the time to rest", &german.window);
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void GermanTest::theGalleriesOfPresetsAreNotCut()
{
    m_shown.reset();
    GermanWindow german;
    QStringList cut;
    int galleries = 0;
    for (const LessonEntry &lesson : german.library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            if (step.presets.empty())
                continue;
            german.session.openStep(lesson.id, step.id);
            settle();
            german.window.findChild<QAbstractButton *>("presets")->click();
            QWidget *gallery = QApplication::activePopupWidget();
            QVERIFY2(gallery, qPrintable(step.id));
            settle();
            for (const QString &where : cutIn(*gallery))
                cut << step.id + ' ' + where;
            gallery->close();
            ++galleries;
        }
    }
    QVERIFY(galleries > 0);
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void GermanTest::thePageOfKeysIsNotSquashed()
{
    m_shown.reset();
    GermanWindow german;
    for (int i = 0; i < 2; ++i) { // it is arranged anew each time
        for (QAction *action : german.window.findChildren<QAction *>()) {
            if (action->shortcuts().contains(QKeySequence(Qt::Key_F1)))
                action->trigger();
        }
        QWidget *page = german.window.findChild<HelpPage *>();
        QTRY_VERIFY(page && page->isVisible());
        settle();
        int rows = 0;
        QStringList squashed;
        for (const QLabel *label : page->findChildren<QLabel *>()) {
            const int lacks = label->heightForWidth(label->width()) - 2 - label->height();
            if (label->isVisible() && (lacks > 0 || label->height() < label->minimumHeight()))
                squashed << label->text();
            rows += label->objectName() == "action" ? 1 : 0;
        }
        QVERIFY(rows > 50);
        QVERIFY2(squashed.isEmpty(), qPrintable(squashed.join(" | ")));
        QTest::keyClick(page, Qt::Key_Escape);
        QVERIFY(!page->isVisible());
    }
}

void GermanTest::theCardsOfTheTourAreNotCut()
{
    m_shown.reset();
    GermanWindow german;
    german.window.startTour();
    Tour *tour = german.window.findChild<Tour *>();
    QStringList cut;
    for (std::size_t stop = 0; stop < tour->count(); ++stop) {
        settle();
        QCOMPARE(tour->stop(), stop);
        for (const QString &where : cutIn(*tour))
            cut << QString("card %1: %2").arg(stop + 1).arg(where);
        QTest::keyClick(tour, Qt::Key_Return);
    }
    QVERIFY(!tour->isRunning());
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void GermanTest::theSandboxIsNotCut()
{
    m_shown.reset();
    GermanWindow german;
    QStringList cut;
    german.window.setMode(MainWindow::Mode::build);
    for (const auto mode : {MainWindow::Mode::build, MainWindow::Mode::measure}) {
        german.window.setMode(mode);
        settle();
        QVERIFY(german.session.isSandbox());
        for (const QString &where : cutIn(*german.window.findChild<BuildPanel *>()))
            cut << (mode == MainWindow::Mode::build ? "build " : "measure ") + where;
    }
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void GermanTest::aSentenceTooLongForTheStatusBarEndsInDots()
{
    m_shown.reset();
    StatusSentence sentence;
    sentence.setText("<b>Leertaste</b> spielt ab, zieh an etwas.");
    sentence.setAttribute(Qt::WA_DontShowOnScreen);
    sentence.show();
    sentence.resize(sentence.sizeHint());
    QVERIFY(!drawnBy(sentence).join(' ').contains(QChar(0x2026)));
    sentence.resize(sentence.width() / 2, sentence.height());
    const QStringList drawn = drawnBy(sentence);
    QCOMPARE(drawn.size(), 1);
    QVERIFY2(drawn[0].startsWith("Leertaste") && drawn[0].endsWith(QChar(0x2026)), qPrintable(drawn[0]));
}

void GermanTest::aWindowThatGoesTakesItsOpenGalleryAlong()
{
    m_shown.reset();
    for (const bool painted : {false, true}) {
        auto german = std::make_unique<GermanWindow>();
        for (const LessonEntry &lesson : german->library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                if (!step.presets.empty())
                    german->session.openStep(lesson.id, step.id);
            }
        }
        settle();
        german->window.findChild<QAbstractButton *>("presets")->click();
        QVERIFY(QApplication::activePopupWidget());
        if (painted)
            settle();
        german.reset();
        QVERIFY(!QApplication::activePopupWidget());
        settle();
    }
}

SUITE(tst_german, GermanTest)
#include "tst_german.moc"
