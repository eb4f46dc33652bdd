#include "tests/lessons/support.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

using namespace support;

/// What the texts of every step of every lesson have in common, found by walking the plugins.
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

    void everyLessonHasAnOrderOfItsOwn()
    {
        QSet<int> orders;
        for (const QString &id : lessonIds())
            orders << loadLesson(id).metadata.value(u"order").toInt();
        QCOMPARE(orders.size(), lessonIds().size());
    }

    void theTextIsShortAndCalm_data() { addStepRows(); }
    void theTextIsShortAndCalm()
    {
        const lessons::Step step = stepOfRow();
        QVERIFY(!step.title.isEmpty());
        const qsizetype words =
            step.narration.split(QRegularExpression(u"\\s+"_qs), Qt::SkipEmptyParts).size();
        QVERIFY2(words >= 40 && words <= 150, qPrintable(QString::number(words)));
        QString all = step.title + step.narration;
        for (const lessons::Try &one : step.tries)
            all += one.text;
        QVERIFY(!all.contains(u'!'));
        QVERIFY2(!all.contains(QRegularExpression(u"\\d (px|rad|°|frames?)\\b"_qs)),
                 "a thin space belongs before a unit");
        const bool isBuilt =
            step.points == lessons::PointsFrom::scene; // there the learner finds things to try
        QVERIFY(isBuilt || (step.tries.size() >= 2 && step.tries.size() <= 4));
    }

    void everyThingToTryHasAHint_data() { addStepRows(); }
    void everyThingToTryHasAHint()
    {
        for (const lessons::Try &one : stepOfRow().tries) {
            QVERIFY2(!one.hint.isEmpty(), qPrintable(one.text));
            QVERIFY2(one.hint != one.text && one.hint.endsWith(u'.'), qPrintable(one.hint));
            QVERIFY2(!one.hint.contains(u'!') && one.hint.size() <= 260, qPrintable(one.hint));
        }
    }

    void everyStepSaysWhatIsLearnt_data() { addStepRows(); }
    void everyStepSaysWhatIsLearnt()
    {
        if (stepOfRow().points == lessons::PointsFrom::scene)
            return; // what is learnt there, the learner decides
        const QString learnt = stepOfRow().explanation.learnt;
        QVERIFY(learnt.size() >= 30 && learnt.size() <= 160);
        QVERIFY2(learnt.endsWith(u'.') && !learnt.contains(QRegularExpression(u"[.!?] "_qs)), "one sentence");
    }

    /// The panel is narrow, and a formula must not be broken.
    void formulasOfAnswersFitIntoALine_data() { addStepRows(); }
    void formulasOfAnswersFitIntoALine()
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

QTEST_GUILESS_MAIN(LessonTexts)
#include "tst_lesson_texts.moc"
