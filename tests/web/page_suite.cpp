#include "tests/web/page_suite.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>

namespace web {

QByteArray springstep(const QStringList &arguments)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("SPRINGSTEP_LESSONS", LESSON_DIR);
    process.setProcessEnvironment(environment);
    process.start(PROGRAM, arguments);
    if (!process.waitForFinished(120'000) || process.exitCode() != 0)
        qFatal("%s: %s", qPrintable(arguments.join(' ')), process.readAllStandardError().constData());
    return process.readAllStandardOutput();
}

QJsonObject walker()
{
    return {{"lesson", "walking_gait"}, {"step", "ground"}, {"frames", 600}};
}

PageSuite::PageSuite()
{
    m_walkerPage = page(file("walker", walker()));
}

QString PageSuite::file(const QString &name, QJsonObject experiment)
{
    experiment["format"] = "springstep-experiment/1";
    QFile file(m_folder.filePath(name + ".json"));
    if (!file.open(QFile::WriteOnly))
        qFatal("The experiment cannot be written.");
    file.write(QJsonDocument(experiment).toJson());
    return file.fileName();
}

QString PageSuite::page(const QString &experiment, const QStringList &options)
{
    const QString out = QFileInfo(experiment).path() + '/' + QFileInfo(experiment).baseName() + ".html";
    springstep(QStringList{"film", experiment, out} + options);
    return out;
}

}
