#include "app/ui/film/film_name.h"

#include "app/model/film/film_file.h"
#include "app/model/text/quoting.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/file_row.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace app {

namespace {

/// Returns the name, with a number if it is taken, so that an earlier film is not replaced.
QString freeName(const QString &name, const QString &ending)
{
    QString free = name + ending;
    for (int i = 2; QFileInfo::exists(free); ++i)
        free = QStringLiteral("%1_%2%3").arg(name, QString::number(i), ending);
    return free;
}

}

FilmName::FilmName(QWidget *parent) : QWidget(parent)
{
    const auto [field, choose] = makeFileRow(tr("Where to save the film"), this);
    m_field = field;
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_field, 1);
    row->addWidget(choose);
    connect(choose, &QPushButton::clicked, this, &FilmName::choose);
    connect(m_field, &QLineEdit::textChanged, this, [this] {
        forbidReplacing();
        emit changed();
    });
}

QString FilmName::name() const
{
    return m_field->text();
}

void FilmName::setName(const QString &name)
{
    m_field->setText(name);
}

void FilmName::suggest(const QString &folder, const QString &name)
{
    const QString suggestion = freeName(folder + '/' + name, ".gif");
    if (m_field->text() == m_suggested)
        m_field->setText(suggestion);
    m_suggested = suggestion;
}

QString FilmName::objection(std::int64_t from, std::int64_t to) const
{
    const QStringList files = filesInTheWay(name(), from, to);
    if (files.isEmpty() || mayReplace())
        return {};
    if (filmKind(name()) != FilmKind::pictures)
        return tr("%1 already exists. Replace it, or choose another name.").arg(shownPath(files.first()));
    return tr("Such pictures already exist, for example %1. Replace them, or choose another name.")
        .arg(shownPath(files.first()));
}

void FilmName::choose()
{
    const QString path = askWhereToSave(this, tr("Film of the run"), name(),
                                        tr("Films (*.gif *.webm);;Pictures of each frame (*.png)"));
    if (path.isEmpty())
        return;
    const bool isPicture = path.endsWith(".png", Qt::CaseInsensitive) && !path.contains('%');
    setName(isPicture ? path.chopped(4) + "_%04d.png" : path);
    forbidReplacing();
    if (name() == path && QFileInfo(path).isFile())
        allowReplacing(); // the file dialog has asked already
    emit changed();
}

}
