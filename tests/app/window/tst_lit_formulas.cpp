// Formulas that mark their subjects: in the scene and among the parameters.

#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/why_box.h"
#include "app/ui/learn/why_text.h"
#include "app/ui/parameters/parameter_row.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QSettings>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

using lessons::Highlight;
using Highlights = std::vector<Highlight>;

/// The window on a step of two bodies, with the answer to its first question that has formulas with braces unfolded.
class FormulaWindow : public WindowFixture
{
public:
    FormulaWindow() : WindowFixture({.lesson = "two_body", .step = "mutual"})
    {
        QTest::mouseClick(&question(), Qt::LeftButton);
        settle();
    }

    const std::vector<lessons::Formula> &formulas() const { return why().formulas; }
    const lessons::Why &why() const { return session.step().explanation.whys.at(place()); }
    WhyBox &box() const
    {
        return *part<Narration>().findChildren<WhyBox *>().at(static_cast<qsizetype>(place()));
    }
    WhyButton &question() const { return *box().findChild<WhyButton *>(); }
    WhyText &answer() const { return *box().findChild<WhyText *>(); }
    const Highlights &shown() const { return view.shown().highlights; }
    void pointAt(std::size_t formula)
    {
        moveMouse(*answer().viewport(), answer().formulaBox(formula).center());
    }
    void leave()
    {
        QEvent event(QEvent::Leave);
        QCoreApplication::sendEvent(&answer(), &event);
    }
    bool isMarked(const QString &parameter) const
    {
        for (const ParameterRow *row : window.findChildren<ParameterRow *>()) {
            if (row->parameter().id == parameter)
                return row->isMarked();
        }
        return false;
    }

private:
    /// Returns the place of the first question with three formulas or more.
    std::size_t place() const
    {
        std::size_t i = 0;
        while (session.step().explanation.whys.at(i).formulas.size() < 3)
            ++i;
        return i;
    }
};

}

class LitFormulasTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void theAnswerHasNoBraces();
    void pointingAtALineMarksItsSubjects();
    void marksAreDrawn();
    void tabGoesFromFormulaToFormula();
    void aClickKeepsTheMarks();
    void foldingTheAnswerClears();
    void anotherStepClears();
    void marksFollowTheRun();
    void theSceneTellsScreenReadersWhatIsMarked();
};

void LitFormulasTest::theAnswerHasNoBraces()
{
    FormulaWindow fixture;
    QVERIFY(fixture.answer().isVisible());
    QVERIFY(!fixture.answer().toPlainText().contains('{'));
    for (std::size_t i = 0; i < fixture.formulas().size(); ++i) {
        QVERIFY(fixture.answer().toPlainText().contains(fixture.formulas()[i].text));
        QVERIFY(!fixture.answer().formulaBox(i).isEmpty());
    }
}

void LitFormulasTest::pointingAtALineMarksItsSubjects()
{
    FormulaWindow fixture;
    QVERIFY(fixture.shown().empty());
    for (std::size_t i = 0; i < fixture.formulas().size(); ++i) {
        fixture.pointAt(i);
        QVERIFY(!fixture.shown().empty());
        QVERIFY(fixture.shown() == fixture.formulas()[i].highlights);
        for (const char *parameter : {"k", "damp", "radius"}) {
            const bool isMeant =
                std::any_of(fixture.shown().begin(), fixture.shown().end(), [&](const Highlight &one) {
                    return one.kind == Highlight::Kind::circle
                               ? one.b == parameter
                               : one.kind == Highlight::Kind::thing && one.a == parameter;
                });
            QCOMPARE(fixture.isMarked(parameter), isMeant);
        }
    }
    fixture.leave();
    QVERIFY(fixture.shown().empty());
    QVERIFY(!fixture.isMarked("k") && !fixture.isMarked("damp") && !fixture.isMarked("radius"));
}

void LitFormulasTest::marksAreDrawn()
{
    FormulaWindow fixture;
    const QImage before = fixture.view.picture();
    fixture.pointAt(0);
    QVERIFY(fixture.view.picture() != before);
    fixture.leave();
    QCOMPARE(fixture.view.picture(), before);
}

void LitFormulasTest::tabGoesFromFormulaToFormula()
{
    FormulaWindow fixture;
    fixture.question().setFocus(Qt::TabFocusReason);
    for (const lessons::Formula &formula : fixture.formulas()) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(fixture.answer().hasFocus());
        QVERIFY2(fixture.shown() == formula.highlights, qPrintable(formula.text));
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY(!fixture.answer().hasFocus());
    QVERIFY(fixture.shown().empty());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(fixture.answer().hasFocus());
    QVERIFY(fixture.shown() == fixture.formulas().back().highlights);
}

void LitFormulasTest::aClickKeepsTheMarks()
{
    FormulaWindow fixture;
    const auto click = [&] {
        const QRect box = fixture.answer().formulaBox(0);
        QTest::mouseClick(fixture.answer().viewport(), Qt::LeftButton, {},
                          box.topLeft() + QPoint(8, box.height() - 8));
    };
    fixture.pointAt(0);
    click();
    fixture.leave();
    fixture.view.setFocus();
    QVERIFY(fixture.shown() == fixture.formulas()[0].highlights);
    fixture.pointAt(1);
    QVERIFY(fixture.shown() == fixture.formulas()[1].highlights);
    fixture.leave();
    QVERIFY(fixture.shown() == fixture.formulas()[0].highlights);
    QTest::keyClick(&fixture.answer(), Qt::Key_Escape);
    QVERIFY(fixture.shown().empty());
    click();
    fixture.leave();
    fixture.view.setFocus();
    QVERIFY(fixture.shown() == fixture.formulas()[0].highlights);
    click();
    fixture.leave();
    fixture.view.setFocus();
    QVERIFY(fixture.shown().empty());
}

void LitFormulasTest::foldingTheAnswerClears()
{
    FormulaWindow fixture;
    fixture.pointAt(0);
    QVERIFY(fixture.shown() == fixture.formulas()[0].highlights);
    QTest::mouseClick(&fixture.question(), Qt::LeftButton);
    QVERIFY(fixture.shown().empty());
}

void LitFormulasTest::anotherStepClears()
{
    FormulaWindow fixture;
    fixture.pointAt(0);
    QVERIFY(fixture.shown() == fixture.formulas()[0].highlights);
    fixture.session.openStep("two_body", "leg_line");
    QVERIFY(fixture.shown().empty());
    QVERIFY(!fixture.isMarked("k"));
}

void LitFormulasTest::marksFollowTheRun()
{
    FormulaWindow fixture;
    fixture.pointAt(0);
    const QImage before = fixture.view.picture();
    fixture.goTo(3);
    QVERIFY(fixture.shown() == fixture.formulas()[0].highlights);
    QVERIFY(fixture.view.picture() != before);
}

void LitFormulasTest::theSceneTellsScreenReadersWhatIsMarked()
{
    FormulaWindow fixture;
    Highlights both = {{Highlight::Kind::arrow, "foot", "body"}, {Highlight::Kind::velocity, "foot", {}}};
    fixture.view.setHighlights(both);
    QVERIFY2(fixture.view.accessibleDescription().contains(
                 "The formula is about: the arrow from foot to body, the velocity of foot"),
             qPrintable(fixture.view.accessibleDescription()));
}

SUITE(tst_lit_formulas, LitFormulasTest)
#include "tst_lit_formulas.moc"
