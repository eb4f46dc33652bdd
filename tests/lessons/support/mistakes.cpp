#include "tests/lessons/support/mistakes.h"

#include <QTest>

namespace support {

void addMistakeRows(std::span<const Mistake> mistakes)
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("at");
    QTest::addColumn<QString>("says");
    for (const Mistake &one : mistakes)
        QTest::newRow(one.name) << one.from << one.to << one.at << QString::fromUtf8(one.says);
}

void checkMistake(const QByteArray &good, const QString &file, QString (*mistakeIn)(const QByteArray &text))
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, at);
    QFETCH(QString, says);
    QByteArray broken = good;
    const qsizetype place = broken.indexOf(from);
    QVERIFY(place >= 0);
    broken.replace(place, from.size(), to);
    QVERIFY(broken.contains(at));
    const qsizetype line = broken.left(broken.indexOf(at)).count('\n') + 1;
    const QString begin = QStringLiteral("%1, line %2: ").arg(file).arg(line);
    const QString mistake = mistakeIn(broken);
    QVERIFY2(mistake.startsWith(begin), qPrintable(begin + "\n" + mistake));
    QVERIFY2(mistake.contains(says), qPrintable(mistake));
    QVERIFY2(mistake.endsWith('.'), qPrintable(mistake));
}

}
