// Settings and files that an earlier version saved: a new window restores what they say. The facts here were written down
// when the files were saved; see tests/app/fixtures/saved/README.md.

#include "app/model/files/recent_files.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/dialogs/recovery_list.h"
#include "app/ui/help/tour.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/try_row.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/settings/appearance.h"
#include "app/ui/settings/size_menu.h"
#include "app/ui/window/last_step.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace app;
using namespace tests;

namespace {

QString savedFile(const QString &name)
{
    return QStringLiteral(SOURCE_DIR "/tests/app/fixtures/saved/") + name;
}

/// A window that opens no step, size or colours of its own.
struct RestoredWindow : WindowFixture
{
    explicit RestoredWindow(QSize size = {})
        : WindowFixture({.lesson = {}, .size = size, .scheme = storedScheme()})
    {
    }
};

/// The area of a dock, and whether it is hidden.
struct Place
{
    const char *dock;
    Qt::DockWidgetArea area;
    bool isHidden;
};

}

Q_DECLARE_METATYPE(std::vector<Place>)

class SavedSettingsTest : public QObject
{
    Q_OBJECT

private slots:
    void init();

    void windowHasItsSavedGeometry();
    void theStepThatWasOpenIsOpened();
    void panelsHaveTheirSavedAreasAndVisibility_data();
    void panelsHaveTheirSavedAreasAndVisibility();
    void widthsThatWereDraggedAreKept();
    void thingsToTryStayTicked();
    void appearanceIsAsChosen();
    void theSceneShowsWhatWasChosen();
    void plotsAreThoseThatWereAdded();
    void sectionsOfTheCodeStayFolded();
    void recentFilesAreListed();
    void theTourIsNotOfferedAgain();
    void commandsHaveTheirShortcuts();
    void anExperimentOpensWithItsOtherRuns();
    void anExperimentOfTheSandboxOpens();
    void unsavedRunsAreOffered();
};

/// Gives each test the settings as they were saved.
void SavedSettingsTest::init()
{
    QSettings settings;
    settings.clear();
    const QSettings saved(savedFile("settings.ini"), QSettings::IniFormat);
    QCOMPARE(saved.status(), QSettings::NoError);
    QVERIFY(saved.allKeys().size() > 20);
    for (const QString &key : saved.allKeys())
        settings.setValue(key, saved.value(key));
}

void SavedSettingsTest::windowHasItsSavedGeometry()
{
    const RestoredWindow restored;
    QCOMPARE(restored.window.geometry(), QRect(60, 50, 720, 640));
    QVERIFY(!restored.window.isMaximized() && !restored.window.isFullScreen());
}

void SavedSettingsTest::theStepThatWasOpenIsOpened()
{
    RestoredWindow restored;
    LastStep::load().openIn(restored.session);
    QCOMPARE(restored.session.lesson().id, QString("two_body"));
    QCOMPARE(restored.session.step().id, QString("mutual"));
}

void SavedSettingsTest::panelsHaveTheirSavedAreasAndVisibility_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<MainWindow::Mode>("mode");
    QTest::addColumn<std::vector<Place>>("places");
    constexpr auto left = Qt::LeftDockWidgetArea, right = Qt::RightDockWidgetArea;
    constexpr auto bottom = Qt::BottomDockWidgetArea;
    QTest::newRow("learn") << QSize(1280, 800) << MainWindow::Mode::learn
                           << std::vector<Place>{{"lessons", left, false},      {"code", right, false},
                                                 {"parameters", bottom, false}, {"plots", right, true},
                                                 {"accuracy", right, true},     {"effects", bottom, true},
                                                 {"energy", bottom, true},      {"branches", bottom, true}};
    // Plots that were not moved follow accuracy, or the code in a wide window.
    QTest::newRow("measure") << QSize(1280, 800) << MainWindow::Mode::measure
                             << std::vector<Place>{{"lessons", left, false},      {"code", right, false},
                                                   {"parameters", bottom, false}, {"plots", left, true},
                                                   {"accuracy", left, false},     {"effects", right, false},
                                                   {"energy", right, false},      {"branches", bottom, true}};
    QTest::newRow("build") << QSize(1280, 800) << MainWindow::Mode::build
                           << std::vector<Place>{{"lessons", left, false},    {"code", right, false},
                                                 {"parameters", left, false}, {"plots", right, true},
                                                 {"accuracy", right, true},   {"branches", bottom, true}};
    QTest::newRow("measure in a wide window")
        << QSize(1920, 1080) << MainWindow::Mode::measure
        << std::vector<Place>{{"lessons", left, false},     {"code", left, false},
                              {"parameters", right, false}, {"plots", left, true},
                              {"accuracy", right, false},   {"effects", right, false},
                              {"energy", bottom, false},    {"branches", bottom, true}};
}

void SavedSettingsTest::panelsHaveTheirSavedAreasAndVisibility()
{
    QFETCH(const QSize, size);
    QFETCH(const MainWindow::Mode, mode);
    QFETCH(const std::vector<Place>, places);
    RestoredWindow restored(size);
    restored.window.setMode(mode);
    settle();
    for (const Place &place : places) {
        QVERIFY2(restored.window.dockWidgetArea(&restored.dock(place.dock)) == place.area, place.dock);
        QVERIFY2(restored.dock(place.dock).isHidden() == place.isHidden, place.dock);
    }
}

void SavedSettingsTest::widthsThatWereDraggedAreKept()
{
    const RestoredWindow restored({1280, 800});
    QTRY_COMPARE(restored.dock("code").width(), 430);
}

void SavedSettingsTest::thingsToTryStayTicked()
{
    RestoredWindow restored;
    const Progress &progress = restored.session.progress();
    QVERIFY(progress.isDone("single_spring", "drag", 0));
    QVERIFY(!progress.isDone("single_spring", "drag", 1));
    QVERIFY(progress.isDone("single_spring", "drag", 2));
    QVERIFY(progress.isDone("walking_gait", "ground", 1));
    QVERIFY(!progress.isDone("walking_gait", "ground", 0));
    restored.session.openStep("single_spring", "drag");
    const auto rows = restored.part<Narration>().findChildren<TryRow *>();
    QVERIFY(rows.size() >= 3);
    QVERIFY(rows[0]->isChecked() && !rows[1]->isChecked() && rows[2]->isChecked());
}

void SavedSettingsTest::appearanceIsAsChosen()
{
    QCOMPARE(storedScheme(), Scheme::dark);
    QCOMPARE(storedSize(), 125);
    QCOMPARE(Language::chosen(QSettings().value("window/language").toString()), QString("de"));
    const RestoredWindow restored;
    QVERIFY(restored.action("dark").isChecked());
    QVERIFY(restored.action("lessMotion").isChecked());
    QVERIFY(!restored.window.isAnimated());
    QVERIFY(restored.actionCalled("125\u2009%").isChecked());
}

void SavedSettingsTest::theSceneShowsWhatWasChosen()
{
    const RestoredWindow restored;
    QVERIFY(!restored.view.extras().grid);
    QVERIFY(restored.view.extras().trails);
}

void SavedSettingsTest::plotsAreThoseThatWereAdded()
{
    RestoredWindow restored({1280, 800});
    restored.window.docks().show(Panel::plots, true);
    const auto &cards = restored.window.plots().cards();
    QCOMPARE(cards.size(), std::size_t(2));
    QCOMPARE(cards[0]->plot().title(), QString("y of foot against time"));
    QCOMPARE(cards[1]->plot().title(), QString("speed of foot against time"));
}

void SavedSettingsTest::sectionsOfTheCodeStayFolded()
{
    RestoredWindow restored({1280, 800});
    restored.session.openStep("single_spring", "radial");
    const CodeView &code = restored.part<CodeView>();
    int sections = 0;
    for (const CodeRow &row : code.rows()) {
        if (row.kind != CodeRow::Kind::heading)
            continue;
        if (row.text.contains("Scene"))
            QVERIFY(code.isFolded(row.section));
        else if (row.text.contains("Spring") || row.text.contains("Damping"))
            QVERIFY(!code.isFolded(row.section));
        else
            continue;
        ++sections;
    }
    QVERIFY(sections >= 3);
}

void SavedSettingsTest::recentFilesAreListed()
{
    QCOMPARE(recentFiles(), QStringList({"/home/ada/sandbox.json", "/home/ada/two_feet.json"}));
}

void SavedSettingsTest::theTourIsNotOfferedAgain()
{
    QVERIFY(!Tour::isWanted());
}

void SavedSettingsTest::commandsHaveTheirShortcuts()
{
    QFile file(savedFile("shortcuts.txt"));
    QVERIFY(file.open(QFile::ReadOnly));
    const QStringList saved = QString::fromUtf8(file.readAll()).trimmed().split('\n');
    QCOMPARE(saved.size(), 67);
    const RestoredWindow restored;
    QStringList now;
    for (const QAction *action : restored.window.findChildren<QAction *>()) {
        for (const QKeySequence &keys : action->shortcuts())
            now << keys.toString(QKeySequence::PortableText);
    }
    for (const QString &keys : saved)
        QVERIFY2(now.contains(keys), qPrintable(keys));
}

void SavedSettingsTest::anExperimentOpensWithItsOtherRuns()
{
    RestoredWindow restored;
    restored.window.openFile(savedFile("two_feet.json"));
    QCOMPARE(restored.notice.sentence(), QString());
    QCOMPARE(restored.session.lesson().id, QString("multi_foot"));
    QCOMPARE(restored.session.step().id, QString("two_feet"));
    QVERIFY(restored.window.windowTitle().contains("two_feet.json"));
    QVERIFY(!restored.isMarked());
    restored.goTo(19);
    QCOMPARE(restored.session.editor().parameter("k"), restored.session.step().parameter("k")->defaultValue);
    restored.goTo(20); // it was set here, and acts in the step to frame 21
    QCOMPARE(restored.session.editor().parameter("k"), 0.35);
    const std::vector<Branch> &branches = restored.session.comparisons().branches().all();
    QCOMPARE(branches.size(), std::size_t(2));
    QCOMPARE(branches[0].name, QString("soft legs"));
    QVERIFY(branches[0].isNamed && branches[0].isKept);
    QCOMPARE(branches[0].end, 60);
    QVERIFY(!branches[1].isNamed && branches[1].isKept);
    QCOMPARE(branches[1].end, 50);
    QCOMPARE(branches[1].script->input.size(), std::size_t(1)); // before the drag, k was changed
}

void SavedSettingsTest::anExperimentOfTheSandboxOpens()
{
    RestoredWindow restored;
    restored.window.openFile(savedFile("sandbox.json"));
    QCOMPARE(restored.notice.sentence(), QString());
    QVERIFY(restored.session.isSandbox());
    const auto plan = restored.session.editor().blueprint();
    QCOMPARE(plan->points.size(), std::size_t(2));
    QVERIFY(plan->points[0].fixed && !plan->points[1].fixed);
    QCOMPARE(plan->points[1].mass, 7.0);
    QCOMPARE(plan->points[1].size, 24.0);
    QCOMPARE(plan->springs.size(), std::size_t(1));
    QCOMPARE(plan->springs[0].k, 0.1);
    QCOMPARE(plan->springs[0].length, 90.0);
    restored.goTo(25);
    QCOMPARE(restored.session.editor().parameter("damp"), 0.75);
    QCOMPARE(restored.session.comparisons().branches().all().size(), std::size_t(1));
    QCOMPARE(restored.session.comparisons().branches().all().front().end, 40);
}

void SavedSettingsTest::unsavedRunsAreOffered()
{
    const QTemporaryDir folder;
    for (const char *program : {"killed", "closed"}) {
        QVERIFY(QDir(folder.path()).mkdir(program));
        const QDir saved(savedFile(QString("recovery/") + program));
        QVERIFY(!saved.isEmpty());
        for (const QString &name : saved.entryList(QDir::Files))
            QVERIFY(QFile::copy(saved.filePath(name), folder.filePath(program + ('/' + name))));
    }
    RestoredWindow restored;
    restored.window.autosaveIn(folder.path(), 50);
    QVERIFY2(restored.notice.sentence().contains("2 unsaved scenes"), qPrintable(restored.notice.sentence()));
    QVERIFY(restored.answer("Show them"));
    QCOMPARE(restored.part<RecoveryList>().findChild<QTreeWidget *>()->topLevelItemCount(), 2);
    const auto open = [&](const QString &lesson) {
        QTreeWidget &rows = *restored.part<RecoveryList>().findChild<QTreeWidget *>();
        for (int i = 0; i < rows.topLevelItemCount(); ++i) {
            if (!rows.topLevelItem(i)->text(0).contains(restored.library.lesson(lesson)->title))
                continue;
            rows.setCurrentItem(rows.topLevelItem(i));
            QTest::keyClick(&rows, Qt::Key_Return);
            break;
        }
        return restored.arrives() && restored.session.lesson().id == lesson;
    };
    QVERIFY(open("single_spring"));
    QCOMPARE(restored.session.step().id, QString("fixed_centre"));
    QCOMPARE(restored.session.editor().parameter("k"), 0.45);
    QCOMPARE(restored.frame(), 33);
    restored.actionCalled("Recover scenes…").trigger();
    QVERIFY(!open("walking_gait")); // first the window asks about the scene that is not saved
    QVERIFY(restored.answer("Discard changes"));
    QVERIFY(restored.arrives());
    QCOMPARE(restored.session.lesson().id, QString("walking_gait"));
    QCOMPARE(restored.session.step().id, QString("ground"));
    QCOMPARE(restored.session.editor().parameter("speed"), 10.0);
    QCOMPARE(restored.frame(), 90);
}

SUITE(tst_saved_settings, SavedSettingsTest)
#include "tst_saved_settings.moc"
