#include "app/ui/notebook/hand_in_dialog.h"

#include "app/model/files/gallery.h"
#include "app/model/files/whole_file.h"
#include "app/model/notebook/notebook_file.h"
#include "app/model/text/phrases.h"
#include "app/model/text/quoting.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/caption.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/dialogs/file_row.h"
#include "app/ui/notebook/entry_picture.h"

#include <QApplication>
#include <QCheckBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace app {

namespace {

constexpr int handInMargin = 20;
constexpr int handInWidth = 480;
constexpr int lessonListHeight = 168;
constexpr int lessonRowHeight = 27;
constexpr auto webEnding = ".html";
constexpr auto pdfEnding = ".pdf";

QString nameOfFile(const QString &path)
{
    return shownPath(QFileInfo(path).fileName());
}

/// Returns `picture` with a memory, because the page and the PDF show the same pictures.
EntryPicture remembered(EntryPicture picture)
{
    auto known = std::make_shared<QHash<const NotebookEntry *, QImage>>();
    return [known, picture = std::move(picture)](const NotebookEntry &entry) {
        const auto found = known->constFind(&entry);
        return found != known->constEnd() ? *found : *known->insert(&entry, picture(entry));
    };
}

}

HandInDialog::HandInDialog(const LessonLibrary &library, const Progress &progress, const Notes &notes,
                           const Proofs &proofs, QString gallery, QWidget *parent)
    : QDialog(parent), m_library(library), m_progress(progress), m_notes(notes), m_proofs(proofs),
      m_folder(std::move(gallery))
{
    setWindowTitle(tr("Hand in a notebook"));
    setModal(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(handInMargin, handInMargin, handInMargin, handInMargin);
    column->setSpacing(10);
    auto *intro = new QLabel(
        tr("A notebook has what you did: what you tried, predicted, wrote and built, each with its run. Your "
           "teacher can replay it. Nothing is sent: the files stay on this computer until you pass them on."),
        this);
    intro->setTextFormat(Qt::PlainText);
    intro->setWordWrap(true);
    column->addWidget(intro);
    addFields(*column);
    addFiles(*column);
    addButtons(*column);
    int widest = 0;
    for (const QLabel *label : std::as_const(m_labels))
        widest = std::max(widest, label->sizeHint().width());
    for (QLabel *label : std::as_const(m_labels))
        label->setMinimumWidth(widest);
    resize(handInWidth, sizeHint().height());
}

QCheckBox *HandInDialog::box(const QString &name, const QString &text, const QString &help,
                             QVBoxLayout &column)
{
    auto *box = new QCheckBox(text, this);
    box->setObjectName(name);
    box->setToolTip(help);
    column.addWidget(box);
    connect(box, &QCheckBox::toggled, this, &HandInDialog::followChange);
    return box;
}

QHBoxLayout *HandInDialog::fieldRow(const QString &text, QLineEdit &field)
{
    auto *label = new QLabel(text, this);
    label->setBuddy(&field);
    m_labels << label;
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(&field, 1);
    return row;
}

void HandInDialog::addFields(QVBoxLayout &column)
{
    m_name = new QLineEdit(this);
    m_name->setObjectName("handInName");
    m_name->setMaxLength(static_cast<int>(Notebook::longestName));
    m_name->setPlaceholderText(tr("may stay empty"));
    m_name->setAccessibleName(tr("Name"));
    m_name->setToolTip(tr("Your name for the notebook. Without it, the notebook has no name"));
    column.addLayout(fieldRow(tr("&Name"), *m_name));
    m_lessons = new QListWidget(this);
    m_lessons->setObjectName("handInLessons");
    m_lessons->setAccessibleName(tr("Lessons"));
    m_lessons->setToolTip(tr("Space chooses a lesson, or leaves it out"));
    m_lessons->setFixedHeight(lessonListHeight);
    m_heading = new QLabel(tr("&Lessons, and how much you did in them"), this);
    m_heading->setBuddy(m_lessons);
    column.addWidget(m_heading);
    column.addWidget(m_lessons);
    connect(m_lessons, &QListWidget::itemChanged, this, &HandInDialog::followChange);
    m_gallery = box("handInGallery", {}, tr("Also puts in the scenes that you keep in the gallery"), column);
}

void HandInDialog::addFiles(QVBoxLayout &column)
{
    column.addSpacing(6);
    m_notebook = box("handInNotebook", tr("Note&book (.springstep-notebook)"),
                     tr("A file whose runs your teacher can replay"), column);
    m_page = box("handInPage", tr("&Web page (.html)"), tr("A page to read in any browser, with pictures"),
                 column);
    m_pdf = box("handInPdf", tr("&PDF (.pdf)"), tr("The same on paper"), column);
    m_notebook->setChecked(true);
    const auto [field, choose] = makeFileRow(tr("Where to write, without an ending"), this);
    m_file = field;
    m_file->setObjectName("handInFile");
    QHBoxLayout *row = fieldRow(tr("F&ile"), *m_file);
    row->addWidget(choose);
    column.addLayout(row);
    connect(choose, &QPushButton::clicked, this, &HandInDialog::choose);
    connect(m_file, &QLineEdit::textChanged, this, &HandInDialog::followChange);
}

void HandInDialog::addButtons(QVBoxLayout &column)
{
    m_message = makeCaption({}, this);
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    m_message->setAlignment(Qt::AlignTop);
    column.addWidget(m_message);
    column.addStretch(1);
    auto *close = new QPushButton(tr("Close"), this);
    close->setObjectName("handInClose");
    close->setToolTip(tr("Close this page (Esc)"));
    close->setAutoDefault(false);
    m_write = new QPushButton(this);
    m_write->setObjectName("handInWrite");
    m_write->setDefault(true);
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(m_write);
    column.addLayout(row);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_write, &QPushButton::clicked, this, &HandInDialog::write);
}

QString HandInDialog::message() const
{
    return m_message->text();
}

void HandInDialog::offer()
{
    if (m_file->text().isEmpty())
        m_file->setText(standardFolder(QStandardPaths::DocumentsLocation) + '/' +
                        tr("notebook", "name of a file"));
    list();
    followChange();
    if (!isVisible())
        resize(width(), sizeHint().height());
    showInFront(*this);
    m_name->setFocus();
}

void HandInDialog::list()
{
    m_lessons->clear();
    for (std::size_t i = 0; i < m_library.entries(); ++i) {
        const LessonEntry &lesson = m_library.entry(i);
        const int count = notebookEntries(lesson, m_progress, m_notes);
        if (count == 0)
            continue;
        auto *item = new QListWidgetItem(withRemark(lesson.title, QString::number(count)), m_lessons);
        item->setData(Qt::UserRole, lesson.id);
        item->setSizeHint({0, lessonRowHeight});
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(Qt::Checked);
    }
    m_heading->setVisible(m_lessons->count() > 0);
    m_lessons->setVisible(m_lessons->count() > 0);
    if (m_lessons->count() > 0)
        m_lessons->setCurrentRow(0);
    const std::size_t scenes = m_folder.isEmpty() ? 0 : Gallery(m_folder).all().size();
    m_gallery->setText(tr("Scenes of the &gallery (%1)").arg(scenes));
    m_gallery->setEnabled(scenes > 0);
    m_gallery->setChecked(scenes > 0);
}

QStringList HandInDialog::lessons() const
{
    QStringList ids;
    for (int i = 0; i < m_lessons->count(); ++i) {
        const QListWidgetItem &item = *m_lessons->item(i);
        if (item.checkState() == Qt::Checked)
            ids << item.data(Qt::UserRole).toString();
    }
    return ids;
}

bool HandInDialog::hasContent() const
{
    return !lessons().isEmpty() || m_gallery->isChecked();
}

QString HandInDialog::base() const
{
    QString path = m_file->text().trimmed();
    for (const QLatin1StringView ending :
         {QLatin1StringView(notebookEnding), QLatin1StringView(webEnding), QLatin1StringView(pdfEnding)}) {
        if (path.endsWith(ending, Qt::CaseInsensitive))
            path.chop(ending.size());
    }
    return path;
}

QStringList HandInDialog::files() const
{
    QStringList files;
    for (const auto &[box, ending] :
         {std::pair{m_notebook, notebookEnding}, std::pair{m_page, webEnding}, std::pair{m_pdf, pdfEnding}}) {
        if (box->isChecked())
            files << base() + QLatin1String(ending);
    }
    return files;
}

void HandInDialog::choose()
{
    const QString path = askWhereToSave(this, windowTitle(), base() + QLatin1String(notebookEnding),
                                        tr("Notebooks (*.springstep-notebook)"));
    if (!path.isEmpty())
        m_file->setText(path);
}

/// The permission to replace files was only for the previous settings.
void HandInDialog::followChange()
{
    if (!m_write)
        return; // the dialog is not complete yet
    m_mayReplace = false;
    QStringList names;
    for (const QString &file : files())
        names << nameOfFile(file);
    const bool isNamed = !base().isEmpty() && !base().endsWith('/');
    m_write->setEnabled(hasContent() && isNamed && !names.isEmpty());
    m_write->setText(tr("Wri&te"));
    m_write->setToolTip(tr("Write the files"));
    if (m_lessons->count() == 0 && !m_gallery->isEnabled())
        m_message->setText(tr("There is nothing to hand in yet. Do a thing to try, answer a prediction, or "
                              "keep a scene first."));
    else if (!hasContent())
        m_message->setText(tr("Choose a lesson, or the scenes of the gallery."));
    else if (names.isEmpty())
        m_message->setText(tr("Choose what to write: the notebook, the web page or the PDF."));
    else if (!isNamed)
        m_message->setText(tr("Type the name of a file."));
    else
        m_message->setText(tr("This writes %1.").arg(names.join(QStringLiteral(", "))));
}

void HandInDialog::write()
{
    const QStringList all = files();
    for (const QString &file : all) {
        if (m_mayReplace || !QFileInfo::exists(file))
            continue;
        m_message->setText(
            tr("%1 already exists. Replace it, or choose another name.").arg(nameOfFile(file)));
        m_write->setText(tr("&Replace"));
        m_write->setToolTip(tr("Write the files, and overwrite those that exist"));
        m_mayReplace = true;
        return;
    }
    m_message->setText(tr("Writing…"));
    m_message->repaint();
    QApplication::setOverrideCursor(Qt::WaitCursor);
    QString result;
    try {
        writeFiles(all);
        QStringList names;
        for (const QString &file : all)
            names << nameOfFile(file);
        result = tr("%1 written to %2.")
                     .arg(names.join(QStringLiteral(", ")), shownPath(QFileInfo(all.first()).absolutePath()));
    } catch (const UserError &error) {
        result = tr("Could not write: %1").arg(error.sentence());
    }
    QApplication::restoreOverrideCursor();
    followChange();
    m_message->setText(result);
}

void HandInDialog::writeFiles(const QStringList &files) const
{
    const NotebookPlan plan{.name = m_name->text(),
                            .lessons = lessons(),
                            .gallery = m_gallery->isChecked() ? m_folder : QString()};
    const Notebook notebook = collectNotebook(plan, m_library, m_progress, m_notes, m_proofs);
    const EntryPicture picture = remembered(entryPicture(m_library));
    // All contents first, so that a mistake writes nothing.
    std::vector<QByteArray> contents;
    for (const QString &file : files)
        contents.push_back(file.endsWith(QLatin1String(pdfEnding)) ? notebookPdf(notebook, m_library, picture)
                           : file.endsWith(QLatin1String(webEnding))
                               ? notebookHtml(notebook, m_library, picture)
                               : notebookText(notebook));
    for (qsizetype i = 0; i < files.size(); ++i)
        writeWholeFile(files[i], contents[static_cast<std::size_t>(i)]);
}

}
