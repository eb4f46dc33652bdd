#include "app/model/lesson_library.h"
#include "app/model/session.h"
#include "app/ui/code/code_ink.h"
#include "app/ui/code/code_panel.h"
#include "app/ui/code/code_view.h"
#include "app/ui/theme/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QShortcut>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>

using namespace app;

namespace {

const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

/// A window with nothing but the panel, on show.
struct Shown
{
    explicit Shown(const QString &lesson = "multi_foot", const QString &step = "any_number")
    {
        session.openStep(lesson, step);
        window.resize(480, 600);
        panel = new CodePanel(session, theme, &window);
        panel->resize(window.size());
        panel->titleActions()->setParent(&window);
        window.show();
        window.activateWindow();
    }
    CodeView &view() { return panel->view(); }

    std::size_t row(const QString &part, CodeRow::Kind kind = CodeRow::Kind::code)
    {
        const auto &rows = view().rows();
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const CodeRow &one) {
            return one.kind == kind && one.text.contains(part);
        });
        return static_cast<std::size_t>(found - rows.begin());
    }
    std::size_t heading(const QString &part) { return row(part, CodeRow::Kind::heading); }
    std::size_t sectionOf(std::size_t atRow) { return view().rows()[atRow].section; }

    void click(std::size_t atRow)
    {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, view().rowRect(atRow).center());
    }
    QToolButton *button(const QString &accessible)
    {
        for (QToolButton *one : panel->titleActions()->findChildren<QToolButton *>()) {
            if (one->accessibleName().contains(accessible))
                return one;
        }
        return nullptr;
    }
    /// The colour of the viewport at the very right of a row.
    QColor colorOf(std::size_t atRow)
    {
        const QImage image = view().viewport()->grab().toImage();
        const QRect rect = view().rowRect(atRow);
        return image.pixelColor(rect.right() - 1, rect.center().y());
    }

    Session session{library()};
    Theme theme{Scheme::light};
    QWidget window;
    CodePanel *panel = nullptr;
};

QColor styleColor(CodeView &view, Ink ink)
{
    const long bgr = view.SendScintilla(QsciScintilla::SCI_STYLEGETFORE, static_cast<unsigned long>(ink), 0L);
    return QColor(int(bgr & 0xff), int(bgr >> 8 & 0xff), int(bgr >> 16 & 0xff));
}

QString marginText(CodeView &view, std::size_t row)
{
    QByteArray text(16, '\0');
    const long length = view.SendScintilla(QsciScintilla::SCI_MARGINGETTEXT, static_cast<unsigned long>(row),
                                           static_cast<void *>(text.data()));
    return QString::fromUtf8(text.left(length));
}

/// Counts timer events of the whole program.
struct TimerWatch : QObject
{
    int events = 0;
    bool eventFilter(QObject *, QEvent *event) override
    {
        events += event->type() == QEvent::Timer;
        return false;
    }
};

}

/// The panel with the code that runs, used with mouse and keyboard.
class TestCodePanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("springstep-test");
        QCoreApplication::setApplicationName("tst_code_panel");
        QVERIFY(!library().lessons.empty());
    }

    void theMarginShowsTheLineNumbersOfTheFiles()
    {
        Shown shown;
        int seen = 0;
        const auto &rows = shown.view().rows();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].kind != CodeRow::Kind::code) {
                QCOMPARE(marginText(shown.view(), i), QString());
                continue;
            }
            const CodeLine &line = shown.panel->listing().sections[rows[i].section].lines[rows[i].line];
            QCOMPARE(marginText(shown.view(), i), QString::number(line.source.number));
            QCOMPARE(shown.view().text(int(i)).trimmed(), line.source.text.trimmed());
            ++seen;
        }
        QVERIFY(seen > 30);
    }

    void everyRowIsTwentyPixelsHigh()
    {
        Shown shown;
        QCOMPARE(shown.view().rowRect(shown.heading("Scene")).height(), 20);
        QCOMPARE(shown.view().rowRect(1).top() - shown.view().rowRect(0).top(), 20);
    }

    void theShownCodeCannotBeChanged()
    {
        Shown shown;
        const QString before = shown.view().text();
        shown.view().setFocus();
        QTest::keyClicks(&shown.view(), "x = 1;");
        QTest::keyClick(&shown.view(), Qt::Key_Delete);
        QTest::keyClick(&shown.view(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(shown.view().text(), before);
    }

    void aClickOnAHeadingHidesItsLinesAndAnotherShowsThem()
    {
        Shown shown;
        const std::size_t heading = shown.heading("Scene");
        const std::size_t line = heading + 2;
        QVERIFY(!shown.view().rowRect(line).isEmpty());
        shown.click(heading);
        QVERIFY(shown.view().isFolded(shown.sectionOf(heading)));
        QVERIFY(shown.view().rowRect(line).isEmpty());
        QVERIFY(!shown.view().rowRect(shown.heading("the order")).isEmpty());
        shown.click(heading);
        QVERIFY(!shown.view().rowRect(line).isEmpty());
    }

    void theKeyboardGoesFromHeadingToHeadingAndFolds()
    {
        Shown shown;
        shown.view().setFocus(Qt::TabFocusReason);
        const std::size_t order = shown.heading("the order");
        QVERIFY(shown.view().isFolded(shown.sectionOf(order))); // from the start: it is for the curious
        QTest::keyClick(&shown.view(), Qt::Key_Down);
        QTest::keyClick(&shown.view(), Qt::Key_Return);
        QVERIFY(!shown.view().isFolded(shown.sectionOf(order)));
        QVERIFY(!shown.view().rowRect(order + 1).isEmpty());
        QTest::keyClick(&shown.view(), Qt::Key_Up);
        QTest::keyClick(&shown.view(), Qt::Key_Enter, Qt::KeypadModifier);
        QVERIFY(shown.view().isFolded(0));
    }

    void aFoldedSectionStaysFoldedInTheNextStep()
    {
        Shown shown;
        shown.click(shown.heading("Scene"));
        shown.session.openFollowing();
        QVERIFY(shown.view().isFolded(0));
        QVERIFY(shown.view().rowRect(1).isEmpty());
    }

    void keysThatSteerTheWindowReachIt_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<int>("modifiers");
        QTest::newRow("Space") << int(Qt::Key_Space) << int(Qt::NoModifier);
        QTest::newRow("Right") << int(Qt::Key_Right) << int(Qt::NoModifier);
        QTest::newRow("Shift+Left") << int(Qt::Key_Left) << int(Qt::ShiftModifier);
        QTest::newRow("Home") << int(Qt::Key_Home) << int(Qt::NoModifier);
        QTest::newRow("Page Down") << int(Qt::Key_PageDown) << int(Qt::NoModifier);
    }
    void keysThatSteerTheWindowReachIt()
    {
        QFETCH(int, key);
        QFETCH(int, modifiers);
        Shown shown;
        QVERIFY(QTest::qWaitForWindowActive(&shown.window));
        QShortcut shortcut(QKeySequence(modifiers | key), &shown.window);
        QSignalSpy activated(&shortcut, &QShortcut::activated);
        shown.view().setFocus();
        QTest::keyClick(&shown.view(), Qt::Key(key), Qt::KeyboardModifiers(modifiers));
        QCOMPARE(activated.count(), 1);
    }

    void theThemeColoursTheCode()
    {
        Shown shown;
        const std::size_t gap = shown.row({}, CodeRow::Kind::gap);
        for (const Scheme scheme : {Scheme::dark, Scheme::light}) {
            shown.theme.setScheme(scheme);
            const Tokens &t = shown.theme.tokens();
            QCOMPARE(styleColor(shown.view(), Ink::keyword), t.keyword);
            QCOMPARE(styleColor(shown.view(), Ink::number), t.number);
            QCOMPARE(styleColor(shown.view(), Ink::type), t.type);
            QCOMPARE(styleColor(shown.view(), Ink::comment), t.comment);
            QCOMPARE(styleColor(shown.view(), Ink::plain), t.ink);
            QCOMPARE(shown.colorOf(gap), t.panel);
        }
    }

    void wordsHaveTheirColours_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QByteArray>("inks"); ///< one letter a character
        QTest::newRow("declaration") << "const Vec2 d = 2.5;" << QByteArray("kkkkk tttt p p nnnp");
        QTest::newRow("comment") << "x // int 3" << QByteArray("p cccccccc");
        QTest::newRow("text") << "f(\"k\")" << QByteArray("ppsssp");
        QTest::newRow("digit in a name") << "foot0 = 1e-3" << QByteArray("ppppp p nnnn");
    }
    void wordsHaveTheirColours()
    {
        QFETCH(QString, line);
        QFETCH(QByteArray, inks);
        const QHash<char, Ink> letters = {{'p', Ink::plain}, {'k', Ink::keyword}, {'n', Ink::number},
                                          {'t', Ink::type},  {'c', Ink::comment}, {'s', Ink::text}};
        const QByteArray got = inksOf(line);
        QCOMPARE(got.size(), line.size());
        for (qsizetype i = 0; i < inks.size(); ++i) {
            if (inks[i] != ' ')
                QCOMPARE(static_cast<Ink>(got[i]), letters[inks[i]]);
        }
    }

    void aByteOfALongCharacterHasItsLinesColour()
    {
        QCOMPARE(inksOf("// −1").size(), QByteArray("// −1").size());
    }

    void insideAFrameTheLastPhaseIsMarkedAndTheRestIsToCome()
    {
        Shown shown;
        shown.session.phaseForward();
        shown.session.phaseForward();
        const Tokens &t = shown.theme.tokens();
        const std::size_t result = shown.row("v = keep * v");
        QCOMPARE(shown.colorOf(result + 1), t.wash2);
        QCOMPARE(shown.view().wash(result), t.wash);
        QCOMPARE(shown.view().chipText(result).isEmpty(), false);
        QVERIFY(shown.view().isToCome(shown.row("x = x + h * v")));
        QVERIFY(!shown.view().isToCome(shown.row("pull = k * d")));
        QVERIFY(!shown.view().wash(shown.row("pull = k * d")).isValid());
        const auto mask = static_cast<unsigned long>(
            shown.view().SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, shown.row("x = x + h * v")));
        QCOMPARE(shown.view().SendScintilla(QsciScintilla::SCI_INDICATORVALUEAT, 9UL, long(mask + 4)), 1L);
        shown.session.frameForward();
        QVERIFY(!shown.view().wash(result).isValid());
        QVERIFY(!shown.view().isToCome(shown.row("x = x + h * v")));
        QCOMPARE(shown.colorOf(result + 1), t.panel);
    }

    void theLineThatIsNowIsAlwaysInSight()
    {
        Shown shown("gravity_walls", "gravity");
        shown.window.resize(400, 240);
        shown.panel->resize(400, 240);
        const int phases = shown.session.timeline().track().phasesPerRow();
        QVERIFY(phases > 5);
        for (int i = 1; i < phases; ++i) {
            shown.session.phaseForward();
            std::size_t now = 0;
            for (std::size_t row = 0; row < shown.view().rows().size(); ++row) {
                if (shown.view().wash(row) == shown.theme.tokens().wash)
                    now = row;
            }
            QVERIFY(now > 0);
            QVERIFY(shown.view().viewport()->rect().contains(shown.view().rowRect(now)));
        }
    }

    void valuesFollowTheSelectedBody()
    {
        Shown shown;
        QSignalSpy captions(shown.panel, &CodePanel::captionChanged);
        shown.session.frameForward();
        QCOMPARE(shown.panel->caption(), QString("values of foot 0"));
        const QString before = shown.view().chipText(shown.row("x = x + h * v"));
        QVERIFY(!before.isEmpty());
        shown.session.select("foot3");
        QCOMPARE(captions.count(), 1);
        QCOMPARE(shown.panel->caption(), QString("values of foot 3"));
        QVERIFY(shown.view().chipText(shown.row("x = x + h * v")) != before);
        shown.session.select("body");
        QCOMPARE(shown.panel->caption(), QString("values of the body"));
    }

    void aValueThatDoesNotFitIsNeverCutShort()
    {
        Shown shown;
        shown.session.frameForward();
        for (int width = 700; width >= 160; width -= 20) {
            shown.panel->resize(width, 600);
            for (std::size_t row = 0; row < shown.view().rows().size(); ++row) {
                const QString text = shown.view().chipText(row);
                QVERIFY2(text.count('(') == text.count(')'), qPrintable(text));
            }
        }
        QCOMPARE(shown.view().chipText(shown.row("pull = k * d")), QString("…"));
    }

    void aParameterThatChangesChangesItsChip()
    {
        Shown shown;
        const std::size_t row = shown.row("values[\"k\"]");
        const QString before = shown.view().chipText(row);
        shown.session.setParameter("k", 0.35);
        QVERIFY(shown.view().chipText(row) != before);
        QVERIFY(shown.view().chipText(row).contains("0.35"));
    }

    void anotherMethodShowsItsOwnCode()
    {
        Shown shown;
        QVERIFY(shown.heading("Published") < shown.view().rows().size());
        shown.session.setMethod("semi_implicit_euler");
        QVERIFY(shown.heading("Published") == shown.view().rows().size());
        QVERIFY(shown.heading("Kick") < shown.view().rows().size());
    }

    void theButtonGoesThroughTheNewLines()
    {
        Shown shown;
        QToolButton *button = shown.button("new");
        QVERIFY(button && !button->isHidden());
        const QString count = QString::number(shown.panel->listing().newLines());
        QCOMPARE(button->text(), count + " lines new");
        QSet<QString> blocks;
        for (int i = 0; i < 40; ++i) {
            QTest::mouseClick(button, Qt::LeftButton);
            const QString selected = shown.view().selectedText();
            QVERIFY(!selected.isEmpty());
            blocks << selected;
        }
        const QStringList went = QStringList(blocks.begin(), blocks.end()).join('\n').split('\n');
        QStringList fresh;
        for (const CodeSection &section : shown.panel->listing().sections) {
            for (const CodeLine &line : section.lines) {
                if (line.isNew)
                    fresh << line.source.text;
            }
        }
        QCOMPARE(QSet<QString>(went.begin(), went.end()), QSet<QString>(fresh.begin(), fresh.end()));
    }

    void theFirstStepOfAllHasNoNewLines()
    {
        const LessonEntry &first = library().lessons.front();
        Shown shown(first.id, first.steps.front().id);
        QCOMPARE(shown.panel->listing().newLines(), 0);
        QVERIFY(shown.button("new")->isHidden());
    }

    void copyTakesTheShownCodeWithItsFiles_data()
    {
        QTest::addColumn<bool>("keyboard");
        QTest::newRow("button") << false;
        QTest::newRow("keyboard") << true;
    }
    void copyTakesTheShownCodeWithItsFiles()
    {
        QFETCH(bool, keyboard);
        Shown shown;
        QApplication::clipboard()->clear();
        if (keyboard)
            QTest::keyClick(&shown.view(), Qt::Key_C, Qt::ControlModifier);
        else
            QTest::mouseClick(shown.button("Copy"), Qt::LeftButton);
        const QString text = QApplication::clipboard()->text();
        QVERIFY(text.contains("// sim/effects/radial_spring.h:"));
        QVERIFY(text.contains("    x = x + h * v;\n"));
        QVERIFY(!text.contains("addForcePhases")); // the order is folded
        QVERIFY(!text.contains("//!"));
    }

    void selectedTextIsCopiedAlone()
    {
        Shown shown;
        const int row = int(shown.row("pull = k * d"));
        shown.view().setSelection(row, 4, row, 9);
        QTest::keyClick(&shown.view(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), QString("const"));
    }

    void whilePlayingValuesChangeAtMostTenTimesASecond()
    {
        Shown shown;
        std::vector<CodeChip> last;
        int changes = 0;
        int frames = 0;
        QElapsedTimer clock;
        connect(&shown.session, &Session::moved, this, [&] {
            ++frames;
            changes += shown.view().values() != last;
            last = shown.view().values();
        });
        clock.start();
        shown.session.play();
        QTest::qWait(1500);
        shown.session.pause();
        QVERIFY2(changes >= 3 && changes <= clock.elapsed() / 100 + 1, qPrintable(QString::number(changes)));
        QVERIFY(frames > changes);
        // Stopped, they are those of the moment at once.
        const sim::Segment &segment = shown.session.timeline().track().shown();
        const auto current = chipsOf(shown.panel->listing(), shown.session.moments(), segment, 0);
        QVERIFY(!current.empty());
        const auto &values = shown.view().values();
        QVERIFY(std::equal(current.begin(), current.end(), values.begin()));
    }

    void playingDoesNotScroll()
    {
        Shown shown;
        shown.session.frameForward();
        const QRect before = shown.view().rowRect(0);
        shown.session.play();
        QTest::qWait(300);
        shown.session.pause();
        QCOMPARE(shown.view().rowRect(0), before);
    }

    void whatRunsInEveryFrameComesIntoViewWhenTheRunBegins()
    {
        Shown shown;
        QCOMPARE(shown.view().rowRect(0).top(), 0);
        shown.session.frameForward();
        QCOMPARE(shown.view().rowRect(shown.heading("1 Springs")).top(), 0);
    }

    void nothingRunsWhileNothingMoves()
    {
        Shown shown;
        QVERIFY(QTest::qWaitForWindowActive(&shown.window));
        shown.view().setFocus(Qt::TabFocusReason);
        shown.session.phaseForward();
        QTest::qWait(300);
        TimerWatch watch;
        qApp->installEventFilter(&watch);
        QTest::qWait(1200);
        QCOMPARE(watch.events, 0);
    }

    void readersAreToldWhatItIs()
    {
        Shown shown;
        QCOMPARE(shown.view().accessibleName(), QString("Code that runs"));
        for (const QToolButton *button : shown.panel->titleActions()->findChildren<QToolButton *>()) {
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(!button->toolTip().isEmpty());
        }
    }

    void focusFromTheKeyboardIsVisible()
    {
        Shown shown;
        QVERIFY(QTest::qWaitForWindowActive(&shown.window));
        shown.view().clearFocus();
        const QImage without = shown.view().viewport()->grab().toImage();
        shown.view().setFocus(Qt::TabFocusReason);
        const QImage with = shown.view().viewport()->grab().toImage();
        QVERIFY(with != without);
    }
};

QTEST_MAIN(TestCodePanel)
#include "tst_code_panel.moc"
