// A printed lesson has everything that a learner needs, asks before it answers, and can be cancelled.

#include "app/model/handout/handout.h"
#include "app/model/handout/paper.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/learning/run_setup.h"
#include "app/model/text/language.h"
#include "app/model/text/pdf.h"
#include "app/ui/film/handout_export.h"
#include "tests/suite.h"

#include <QRegularExpression>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>

using namespace app;

namespace {

/// Returns Markdown as a reader sees it, in one line.
QString shown(QString markdown)
{
    static const QRegularExpression link("\\[([^\\]]+)\\]\\(word:[^)]*\\)");
    QTextDocument text;
    text.setMarkdown(markdown.replace(link, "\\1"), QTextDocument::MarkdownNoHTML);
    return text.toPlainText().simplified();
}

const HandoutPicture noPicture = [](const HandoutMoment &) { return QImage(); };

}

class HandoutTest : public QObject
{
    Q_OBJECT

private slots:
    void aHandoutAsksFirstAndAnswersOnAnotherPage_data();
    void aHandoutAsksFirstAndAnswersOnAnotherPage();
    void picturesShowWherePredictionsBeginAndEnd();
    void aTaskHasALineForEachLineOfItsSolutionUpToAPage();
    void curvesAreDrawn();
    void handoutStopsWhenCancelled();
    void theFileIsAPdf();
    void noHeadingStandsAloneAtTheEndOfAPage();
};

void HandoutTest::aHandoutAsksFirstAndAnswersOnAnotherPage_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("lesson");
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    for (const char *language : {"en", "de"}) {
        for (const LessonEntry &lesson : library.lessons)
            QTest::addRow("%s, %s", language, qPrintable(lesson.id)) << QString(language) << lesson.id;
    }
}

void HandoutTest::aHandoutAsksFirstAndAnswersOnAnotherPage()
{
    QFETCH(QString, language);
    QFETCH(QString, lesson);
    Language spoken(language);
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders(), &spoken);
    const LessonEntry &entry = *library.lesson(lesson);
    QTextDocument document;
    QVERIFY(writeHandout(document, entry, noPicture, {}));
    int breaks = 0;
    QString questions;
    QString answers;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore)
            ++breaks;
        (breaks > 0 ? answers : questions) += block.text().replace(QChar::LineSeparator, ' ') + ' ';
    }
    QCOMPARE(breaks, 1);
    questions = questions.simplified();
    answers = answers.simplified();
    for (const lessons::Step &step : entry.steps) {
        QVERIFY2(questions.contains(step.title), qPrintable(step.id));
        for (const lessons::Try &one : step.tries) {
            QVERIFY2(questions.contains(shown(one.text)), qPrintable(one.id));
            QVERIFY2(one.answer.isEmpty() || answers.contains(shown(one.answer)), qPrintable(one.id));
            QVERIFY2(one.answer.isEmpty() || !questions.contains(shown(one.answer)), qPrintable(one.id));
        }
        for (const lessons::Prediction &prediction : step.predictions) {
            QVERIFY2(questions.contains(shown(prediction.text)), qPrintable(prediction.id));
            QVERIFY2(answers.contains(shown(prediction.answer)), qPrintable(prediction.id));
            QVERIFY2(!questions.contains(shown(prediction.answer)), qPrintable(prediction.id));
        }
    }
    for (const lessons::RecallQuestion &question : entry.recall.questions) {
        QVERIFY2(questions.contains(shown(question.text)), qPrintable(question.id));
        for (const lessons::RecallChoice &choice : question.choices)
            QVERIFY2(questions.contains(shown(choice.text)), qPrintable(choice.text));
        if (!question.choices.empty())
            QVERIFY2(answers.contains(shown(question.choices.front().text)), qPrintable(question.id));
    }
}

void HandoutTest::picturesShowWherePredictionsBeginAndEnd()
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const LessonEntry &lesson = *library.lesson("single_spring");
    std::vector<std::pair<QString, std::int64_t>> expected;
    for (const lessons::Step &step : lesson.steps) {
        expected.emplace_back(step.id, 0);
        for (std::size_t i = 0; i < step.predictions.size(); ++i)
            expected.emplace_back(step.id, 0);
    }
    for (const lessons::Step &step : lesson.steps) {
        for (const lessons::Prediction &prediction : step.predictions) {
            if (prediction.question.kind != lessons::Question::Kind::place)
                continue;
            FollowedRun run(step, scriptFor(prediction.run, step));
            expected.emplace_back(step.id, runToEnd(run, prediction.run)->frame);
        }
    }
    std::vector<std::pair<QString, std::int64_t>> drawn;
    QTextDocument document;
    QVERIFY(writeHandout(document, lesson,
                         [&](const HandoutMoment &moment) {
                             drawn.emplace_back(moment.step.id, moment.frame);
                             return QImage();
                         },
                         {}));
    QCOMPARE(drawn, expected);
    QCOMPARE(handoutPictureCount(lesson), static_cast<int>(expected.size()));
}

void HandoutTest::aTaskHasALineForEachLineOfItsSolutionUpToAPage()
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    LessonEntry lesson = *library.lesson("two_body");
    const lessons::Step step = *lesson.step("mutual");
    lesson.steps = {step};
    lesson.steps.front().tries.clear();
    lesson.steps.front().predictions.clear();
    lesson.recall = {};
    QVERIFY(!step.codeTasks.empty());
    int expected = 0;
    for (const lessons::CodeTask &task : step.codeTasks)
        expected += static_cast<int>(
            std::min<qsizetype>(20, step.listing.solution(task.id).trimmed().split('\n').size()));
    QTextDocument document;
    QVERIFY(writeHandout(document, lesson, noPicture, {}));
    int lines = 0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        lines += block.blockFormat().hasProperty(QTextFormat::BlockTrailingHorizontalRulerWidth) ? 1 : 0;
    QCOMPARE(lines, expected);
}

void HandoutTest::curvesAreDrawn()
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    int curves = 0;
    for (const LessonEntry &lesson : library.lessons) {
        int expected = 0;
        for (const lessons::Step &step : lesson.steps) {
            for (const lessons::Prediction &prediction : step.predictions)
                expected += prediction.question.kind == lessons::Question::Kind::curve ? 1 : 0;
        }
        QTextDocument document;
        QVERIFY(writeHandout(document, lesson, noPicture, {}));
        QCOMPARE(document.toPlainText().count(QChar::ObjectReplacementCharacter), expected);
        curves += expected;
    }
    QVERIFY(curves > 0);
}

void HandoutTest::handoutStopsWhenCancelled()
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    QTextDocument document;
    int pictures = 0;
    QVERIFY(!writeHandout(
        document, *library.lesson("two_body"),
        [&](const HandoutMoment &) {
            ++pictures;
            return QImage();
        },
        [&] { return pictures < 2; }));
    QCOMPARE(pictures, 2);
}

void HandoutTest::theFileIsAPdf()
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const LessonEntry &lesson = *library.lesson("two_body");
    QTextDocument document;
    QVERIFY(writeHandout(document, lesson, handoutPicture(library), {}));
    const QByteArray pdf = pdfOf(document, lesson.title);
    QVERIFY(pdf.startsWith("%PDF-"));
    QVERIFY(pdf.trimmed().endsWith("%%EOF"));
    QVERIFY(pdf.count("/Type /Page\n") + pdf.count("/Type /Page ") >= 3);
    QVERIFY(pdf.contains("/Subtype /Image"));
}

void HandoutTest::noHeadingStandsAloneAtTheEndOfAPage()
{
    QImage picture(200, 300, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    QStringList
        moved; // the numbers of paragraphs above a heading that goes to the next page with its picture
    for (int paragraphs = 1; paragraphs <= 40; ++paragraphs) {
        QTextDocument document;
        Paper paper(document);
        for (int i = 0; i < paragraphs; ++i)
            paper.addText("text");
        paper.addHeading(2, "heading");
        paper.addPicture(picture);
        pdfOf(document, "title");
        const QTextBlock heading = document.findBlockByNumber(paragraphs);
        QCOMPARE(heading.text(), QString("heading"));
        if (heading.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore)
            moved << QString::number(paragraphs);
    }
    QVERIFY(moved.size() > 5 && moved.size() < 30);
    QVERIFY(!moved.contains("1") && !moved.contains("40")); // the picture has room on the page
}

SUITE(tst_handout, HandoutTest)
#include "tst_handout.moc"
