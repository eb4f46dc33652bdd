#include "app/ui/code/code_colors.h"
#include "tests/app/code/code_support.h"
#include "tests/suite.h"

#include <QShortcut>
#include <QSignalSpy>

using namespace code_support;

namespace {

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

}

/// How the code is shown, folded and steered with mouse and keyboard.
class TestCodeView : public QObject
{
    Q_OBJECT

private slots:
    void theMarginShowsTheLineNumbersOfTheFiles()
    {
        CodeFixture shown;
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
        CodeFixture shown;
        QCOMPARE(shown.view().rowRect(shown.heading("Scene")).height(), 20);
        QCOMPARE(shown.view().rowRect(1).top() - shown.view().rowRect(0).top(), 20);
    }

    void aClickOnAHeadingHidesItsLinesAndAnotherShowsThem()
    {
        CodeFixture shown;
        const std::size_t heading = shown.heading("Scene");
        const std::size_t line = heading + 2;
        QVERIFY(!shown.view().rowRect(line).isEmpty());
        shown.click(heading);
        QVERIFY(shown.view().isFolded(shown.sectionOf(heading)));
        QVERIFY(shown.view().rowRect(line).isEmpty());
        QVERIFY(!shown.view().rowRect(shown.heading("order of the phases")).isEmpty());
        shown.click(heading);
        QVERIFY(!shown.view().rowRect(line).isEmpty());
    }

    void theKeyboardGoesFromHeadingToHeadingAndFolds()
    {
        CodeFixture shown;
        shown.view().setFocus(Qt::TabFocusReason);
        const std::size_t order = shown.heading("order of the phases");
        QVERIFY(shown.view().isFolded(shown.sectionOf(order))); // from the start: it is for the curious
        QTest::keyClick(&shown.view(), Qt::Key_Down, Qt::ControlModifier);
        QTest::keyClick(&shown.view(), Qt::Key_Return);
        QVERIFY(!shown.view().isFolded(shown.sectionOf(order)));
        QVERIFY(!shown.view().rowRect(order + 1).isEmpty());
        QTest::keyClick(&shown.view(), Qt::Key_Up, Qt::ControlModifier);
        QTest::keyClick(&shown.view(), Qt::Key_Enter, Qt::KeypadModifier);
        QVERIFY(shown.view().isFolded(0));
    }

    void shortcutsOfTheWindowWorkInTheCode_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<int>("modifiers");
        QTest::newRow("Space") << int(Qt::Key_Space) << int(Qt::NoModifier);
        QTest::newRow("Right") << int(Qt::Key_Right) << int(Qt::NoModifier);
        QTest::newRow("Shift+Left") << int(Qt::Key_Left) << int(Qt::ShiftModifier);
        QTest::newRow("Home") << int(Qt::Key_Home) << int(Qt::NoModifier);
        QTest::newRow("Page Down") << int(Qt::Key_PageDown) << int(Qt::NoModifier);
    }
    void shortcutsOfTheWindowWorkInTheCode()
    {
        QFETCH(int, key);
        QFETCH(int, modifiers);
        CodeFixture shown;
        QVERIFY(QTest::qWaitForWindowActive(&shown.window));
        QShortcut shortcut(QKeySequence(modifiers | key), &shown.window);
        QSignalSpy activated(&shortcut, &QShortcut::activated);
        shown.view().setFocus();
        QTest::keyClick(&shown.view(), Qt::Key(key), Qt::KeyboardModifiers(modifiers));
        QCOMPARE(activated.count(), 1);
    }

    void theThemeColoursTheCode()
    {
        CodeFixture shown;
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

    void insideAFrameTheLastPhaseIsHighlightedAndLaterOnesAreDimmed()
    {
        CodeFixture shown;
        shown.session.playback().phaseForward();
        shown.session.playback().phaseForward();
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
        shown.session.playback().frameForward();
        QVERIFY(!shown.view().wash(result).isValid());
        QVERIFY(!shown.view().isToCome(shown.row("x = x + h * v")));
        QCOMPARE(shown.colorOf(result + 1), t.panel);
    }

    void currentLineIsAlwaysVisible()
    {
        CodeFixture shown("gravity_walls", "gravity");
        shown.window.resize(400, 240);
        shown.panel->resize(400, 240);
        const int phases = shown.session.timeline().track().phasesPerOutput();
        QVERIFY(phases > 5);
        for (int i = 1; i <= phases; ++i) { // the last one, too
            shown.session.playback().phaseForward();
            std::size_t now = 0;
            for (std::size_t row = 0; row < shown.view().rows().size(); ++row) {
                if (shown.view().wash(row) == shown.theme.tokens().wash)
                    now = row;
            }
            QVERIFY(now > 0);
            QVERIFY(shown.view().viewport()->rect().contains(shown.view().rowRect(now)));
        }
    }

    void aValueThatDoesNotFitIsNeverCutShort()
    {
        CodeFixture shown;
        shown.session.playback().frameForward();
        shown.panel->resize(700, 600);
        QVERIFY(shown.view().chipText(shown.row("pull = k * d")).endsWith(')')); // there is room for it
        for (int width = 700; width >= 160; width -= 20) {
            shown.panel->resize(width, 600);
            for (std::size_t row = 0; row < shown.view().rows().size(); ++row) {
                const QString text = shown.view().chipText(row);
                QVERIFY2(text.count('(') == text.count(')'), qPrintable(text));
            }
        }
        QCOMPARE(shown.view().chipText(shown.row("pull = k * d")), QString("…"));
    }

    void focusFromTheKeyboardIsVisible()
    {
        CodeFixture shown;
        QVERIFY(QTest::qWaitForWindowActive(&shown.window));
        shown.view().clearFocus();
        const QImage without = shown.view().viewport()->grab().toImage();
        shown.view().setFocus(Qt::TabFocusReason);
        const QImage with = shown.view().viewport()->grab().toImage();
        QVERIFY(with != without);
    }
};

SUITE(tst_code_view, TestCodeView)
#include "tst_code_view.moc"
