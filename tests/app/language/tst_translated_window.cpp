// The window in other languages, whose texts are longer: nothing is cut.

#include "app/ui/help/help_page.h"
#include "app/ui/help/tour.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/stability/stability_panel.h"
#include "app/ui/status/status_figures.h"
#include "app/ui/status/status_sentence.h"
#include "app/ui/window/introduction.h"
#include "tests/app/language/cut_text.h"
#include "tests/app/language/drawn_text.h"
#include "tests/app/language/translated_window.h"
#include "tests/suite.h"

#include <QAbstractButton>
#include <QLabel>
#include <QtTest>

using namespace app;
using namespace tests;

class TranslatedWindowTest : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsCut_data();
    void nothingIsCut();
    void theReasonsOfStabilityAreNotCut_data() { addTranslatedLanguages(); }
    void theReasonsOfStabilityAreNotCut();
    void theGalleriesOfPresetsAreNotCut_data() { addTranslatedLanguages(); }
    void theGalleriesOfPresetsAreNotCut();
    void thePageOfKeysIsNotSquashed_data() { addTranslatedLanguages(); }
    void thePageOfKeysIsNotSquashed();
    void theCardsOfTheTourAreNotCut_data() { addTranslatedLanguages(); }
    void theCardsOfTheTourAreNotCut();
    void theSandboxIsNotCut_data() { addTranslatedLanguages(); }
    void theSandboxIsNotCut();
    void aSentenceTooLongForTheStatusBarEndsInDots();
    void deletedWindowClosesItsOpenGallery();
    void cleanupTestCase() { m_shown.reset(); }

private:
    std::unique_ptr<TranslatedWindow> m_shown; ///< for the rows of one language and size
    QSize m_size;
    QString m_language;
};

void TranslatedWindowTest::nothingIsCut_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<bool>("measuring");
    const QStringList lessons{"single_spring",    "multi_foot", "walking_gait", "swaying_tree",
                              "rigid_constraint", "codeling",   "accuracy",     "hard_cases"};
    const auto add = [&](const QString &language, QSize size, bool measuring, const QStringList &all) {
        for (const QString &lesson : all)
            QTest::addRow("%s, %s, %d px, %s", qPrintable(language), qPrintable(lesson), size.width(),
                          measuring ? "measure" : "learn")
                << language << size << lesson << measuring;
    };
    for (const QString &language : Language::known()) {
        if (language == "en")
            continue;
        add(language, {1280, 800}, false, lessons);
        add(language, {1280, 800}, true,
            language == "de" ? lessons : QStringList{"walking_gait", "accuracy"});
    }
    for (const bool measuring : {false, true}) // the layout is the same in all languages
        add("de", {1920, 1080}, measuring, lessons);
}

void TranslatedWindowTest::nothingIsCut()
{
    QFETCH(QString, language);
    QFETCH(QSize, size);
    QFETCH(QString, lesson);
    QFETCH(bool, measuring);
    if (!m_shown || m_size != size || m_language != language) {
        m_shown.reset(); // first, as there is one language at a time
        m_shown = std::make_unique<TranslatedWindow>(language, size);
        m_size = size;
        m_language = language;
    }
    TranslatedWindow &shown = *m_shown;
    shown.window.setMode(measuring ? MainWindow::Mode::measure : MainWindow::Mode::learn);
    QStringList cut;
    const std::vector<lessons::Step> &steps = shown.library.lesson(lesson)->steps;
    for (const lessons::Step &step : steps) {
        if (measuring && &step != &steps.front() && &step != &steps.back())
            continue; // their parameters and narration are seen in learning
        shown.session.openStep(lesson, step.id);
        shown.session.playback().goTo({3, 1});
        shown.window.docks().show(Panel::energy, measuring);
        shown.window.docks().show(Panel::effects, measuring);
        settle();
        if (measuring) { // the results arrive later, and must fit, too
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

void TranslatedWindowTest::theReasonsOfStabilityAreNotCut()
{
    m_shown.reset();
    QFETCH(QString, language);
    TranslatedWindow shown(language);
    QStringList cut;
    const auto look = [&](const char *what, QWidget *at) {
        settle();
        for (const QString &where : cutIn(*at))
            cut << QString("%1: %2").arg(what, where);
    };
    shown.session.openStep("multi_foot", "any_number");
    shown.window.docks().show(Panel::stability, true);
    look("stability", &shown.window);
    for (const MapPlane plane : {MapPlane::step, MapPlane::damping}) {
        shown.window.stabilityPanel().showMap(plane);
        look(plane == MapPlane::step ? "map of steps" : "map of damping", &shown.window);
    }
    shown.window.stabilityPanel().showSettling(true);
    look("map of the time to rest", &shown.window);
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void TranslatedWindowTest::theGalleriesOfPresetsAreNotCut()
{
    m_shown.reset();
    QFETCH(QString, language);
    TranslatedWindow shown(language);
    QStringList cut;
    int galleries = 0;
    for (const LessonEntry &lesson : shown.library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            if (step.presets.empty())
                continue;
            shown.session.openStep(lesson.id, step.id);
            settle();
            shown.window.findChild<QAbstractButton *>("presets")->click();
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

void TranslatedWindowTest::thePageOfKeysIsNotSquashed()
{
    m_shown.reset();
    QFETCH(QString, language);
    TranslatedWindow shown(language);
    for (int i = 0; i < 2; ++i) { // it is arranged again each time
        for (QAction *action : shown.window.findChildren<QAction *>()) {
            if (action->shortcuts().contains(QKeySequence(Qt::Key_F1)))
                action->trigger();
        }
        QWidget *page = shown.window.findChild<HelpPage *>();
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

void TranslatedWindowTest::theCardsOfTheTourAreNotCut()
{
    m_shown.reset();
    QFETCH(QString, language);
    TranslatedWindow shown(language);
    shown.window.introduction().startTour();
    Tour *tour = shown.window.findChild<Tour *>();
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

void TranslatedWindowTest::theSandboxIsNotCut()
{
    m_shown.reset();
    QFETCH(QString, language);
    TranslatedWindow shown(language);
    QStringList cut;
    shown.window.setMode(MainWindow::Mode::build);
    for (const auto mode : {MainWindow::Mode::build, MainWindow::Mode::measure}) {
        shown.window.setMode(mode);
        settle();
        QVERIFY(shown.session.isSandbox());
        for (const QString &where : cutIn(*shown.window.findChild<BuildPanel *>()))
            cut << (mode == MainWindow::Mode::build ? "build " : "measure ") + where;
    }
    QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
}

void TranslatedWindowTest::aSentenceTooLongForTheStatusBarEndsInDots()
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

void TranslatedWindowTest::deletedWindowClosesItsOpenGallery()
{
    m_shown.reset();
    for (const bool painted : {false, true}) {
        auto shown = std::make_unique<TranslatedWindow>("de");
        for (const LessonEntry &lesson : shown->library.lessons) {
            for (const lessons::Step &step : lesson.steps) {
                if (!step.presets.empty())
                    shown->session.openStep(lesson.id, step.id);
            }
        }
        settle();
        shown->window.findChild<QAbstractButton *>("presets")->click();
        QVERIFY(QApplication::activePopupWidget());
        if (painted)
            settle();
        shown.reset();
        QVERIFY(!QApplication::activePopupWidget());
        settle();
    }
}

SUITE(tst_translated_window, TranslatedWindowTest)
#include "tst_translated_window.moc"
