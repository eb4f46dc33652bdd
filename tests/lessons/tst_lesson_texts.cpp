#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

using namespace support;

/// Tests of the texts of all steps in all lesson plugins.
class LessonTexts : public QObject
{
    Q_OBJECT

private slots:
    void metadataAgreesWithTheCode_data()
    {
        QTest::addColumn<QString>("id");
        for (const QString &id : lessonIds())
            QTest::addRow("%s", qPrintable(id)) << id;
    }
    void metadataAgreesWithTheCode()
    {
        QFETCH(QString, id);
        const LoadedLesson lesson = loadLesson(id);
        QCOMPARE(lesson.metadata.value(u"id").toString(), id);
        QVERIFY(lesson.metadata.value(u"order").toInt() > 0);
        QVERIFY(!lesson.metadata.value(u"title").toString().isEmpty());
        QVERIFY(!lesson.metadata.value(u"summary").toString().isEmpty());
        QStringList ids;
        for (const lessons::Step &step : lesson.steps)
            ids << step.id;
        QCOMPARE(lesson.metadata.value(u"steps").toVariant().toStringList(), ids);
        QCOMPARE(QSet<QString>(ids.begin(), ids.end()).size(), ids.size());
    }

    void lessonsHaveDistinctOrders()
    {
        QSet<int> orders;
        for (const QString &id : lessonIds())
            orders << loadLesson(id).metadata.value(u"order").toInt();
        QCOMPARE(orders.size(), lessonIds().size());
    }

    void narrationIsShortWithoutExclamations_data() { addStepRows(); }
    void narrationIsShortWithoutExclamations()
    {
        const lessons::Step step = stepOfRow();
        QVERIFY(!step.title.isEmpty());
        const qsizetype words =
            step.narration.split(QRegularExpression(u"\\s+"_qs), Qt::SkipEmptyParts).size();
        QVERIFY2(words >= 40 && words <= 180, qPrintable(QString::number(words)));
        QString all = step.title + step.narration;
        for (const lessons::Try &item : step.tries)
            all += item.text;
        all.remove(QRegularExpression(u"`[^`]*`"_qs)); // in code, ! means not
        QVERIFY(!all.contains(u'!'));
        QVERIFY2(!all.contains(QRegularExpression(u"\\d (px|rad|°|frames?)\\b"_qs)),
                 "a thin space belongs before a unit");
        // In the sandbox, learners choose what to try.
        const bool isSandbox = step.points == lessons::PointSource::scene;
        QVERIFY(isSandbox || (step.tries.size() >= 2 && step.tries.size() <= 4));
    }

    void thingsToTryHaveHints_data() { addStepRows(); }
    void thingsToTryHaveHints()
    {
        for (const lessons::Try &item : stepOfRow().tries) {
            QVERIFY2(!item.hint.isEmpty(), qPrintable(item.text));
            QVERIFY2(item.hint != item.text && item.hint.endsWith(u'.'), qPrintable(item.hint));
            QVERIFY2(!item.hint.contains(u'!') && item.hint.size() <= 260, qPrintable(item.hint));
        }
    }

    void stepsSayWhatIsLearnt_data() { addStepRows(); }
    void stepsSayWhatIsLearnt()
    {
        if (stepOfRow().points == lessons::PointSource::scene)
            return; // the sandbox has no fixed learning goal
        const QString learnt = stepOfRow().explanation.learnt;
        QVERIFY(learnt.size() >= 30 && learnt.size() <= 160);
        QVERIFY2(learnt.endsWith(u'.') && !learnt.contains(QRegularExpression(u"[.!?] "_qs)), "one sentence");
    }

    /// The panel is narrow, and a formula must not wrap.
    void formulasOfAnswersFitOnALine_data() { addStepRows(); }
    void formulasOfAnswersFitOnALine()
    {
        for (const lessons::Why &why : stepOfRow().explanation.whys) {
            QVERIFY2(why.question.endsWith(u'?'), qPrintable(why.question));
            QVERIFY2(why.answer.contains(u'`'), qPrintable(why.question));
            for (const QString &part : why.answer.split(u"\n\n"_qs)) {
                const bool isFormula = part.startsWith(u'`') && part.endsWith(u'`');
                QVERIFY2(!isFormula || part.size() <= 2 + 33, qPrintable(part));
            }
        }
    }
};

SUITE(tst_lesson_texts, LessonTexts)
#include "tst_lesson_texts.moc"
