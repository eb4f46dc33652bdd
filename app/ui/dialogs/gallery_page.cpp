#include "app/ui/dialogs/gallery_page.h"

#include "app/model/text/user_error.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/dialogs/recovery_list.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr QSize galleryCard{156, 150};
constexpr QSize galleryPicture{132, 96};
constexpr QSize gallerySize{720, 480};
constexpr int galleryMargin = 16;

}

GalleryPage::GalleryPage(Gallery &gallery, const Theme &theme, QWidget *parent)
    : QDialog(parent), m_gallery(gallery), m_theme(theme), m_cards(new QListWidget(this)),
      m_empty(new QLabel(this)), m_mistakes(new QLabel(this)), m_row(new QWidget(this))
{
    setWindowTitle(tr("Gallery"));
    m_cards->setObjectName("galleryCards");
    m_cards->setAccessibleName(tr("Experiments that you keep"));
    m_cards->setViewMode(QListView::IconMode);
    m_cards->setMovement(QListView::Static);
    m_cards->setResizeMode(QListView::Adjust);
    m_cards->setIconSize(galleryPicture);
    m_cards->setGridSize(galleryCard);
    m_cards->setWordWrap(true);
    m_cards->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_cards->installEventFilter(this);
    m_empty->setObjectName("galleryEmpty");
    m_empty->setWordWrap(true);
    m_empty->setText(
        tr("Nothing is kept here yet. Build something, then press Keep this one: the gallery stores it with "
           "a picture."));
    m_mistakes->setObjectName("galleryMistakes");
    m_mistakes->setWordWrap(true);
    m_mistakes->setTextFormat(Qt::PlainText);
    auto *row = new QHBoxLayout(m_row);
    row->setContentsMargins(0, 0, 0, 0);
    m_open = addButton("galleryOpen", tr("Open"), tr("Open the selected experiment (Return)"));
    m_rename =
        addButton("galleryRename", tr("Rename"), tr("Give the selected experiment another title (F2)"));
    m_remove =
        addButton("galleryRemove", tr("Remove"), tr("Remove the selected experiment from the gallery (Del)"));
    m_undo = addButton("galleryUndo", tr("Undo"), {});
    row->addStretch(1);
    QPushButton *keep =
        addButton("galleryKeep", tr("Keep this one"), tr("Keep the experiment that is open in the window"));
    QPushButton *done = addButton("galleryClose", tr("Close"), tr("Close the gallery (Esc)"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(galleryMargin, galleryMargin, galleryMargin, galleryMargin);
    column->setSpacing(12);
    column->addWidget(m_empty);
    column->addWidget(m_cards, 1);
    column->addWidget(m_mistakes);
    column->addWidget(m_row);
    connect(m_open, &QPushButton::clicked, this, &GalleryPage::openSelected);
    connect(m_rename, &QPushButton::clicked, this, &GalleryPage::renameSelected);
    connect(m_remove, &QPushButton::clicked, this, &GalleryPage::removeSelected);
    connect(m_undo, &QPushButton::clicked, this, &GalleryPage::undo);
    connect(keep, &QPushButton::clicked, this, &GalleryPage::keepRequested);
    connect(done, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_cards, &QListWidget::itemDoubleClicked, this, &GalleryPage::openSelected);
    connect(m_cards, &QListWidget::itemSelectionChanged, this, &GalleryPage::refreshButtons);
    connect(m_cards, &QListWidget::itemChanged, this, [this](QListWidgetItem *card) {
        if (!m_isListing)
            attemptChange([&] { m_gallery.rename(card->data(Qt::UserRole).toString(), card->text()); });
    });
    connect(&gallery, &Gallery::changed, this, &GalleryPage::list,
            Qt::QueuedConnection); // not while a card is edited
    list();
    resize(gallerySize);
}

QPushButton *GalleryPage::addButton(const QString &name, const QString &text, const QString &tip)
{
    auto *button = new QPushButton(text, m_row);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAutoDefault(false); // Return is for the cards
    m_row->layout()->addWidget(button);
    return button;
}

void GalleryPage::open()
{
    m_failure.clear();
    m_gallery.refresh();
    list();
    showInFront(*this);
    m_cards->setFocus();
}

void GalleryPage::list()
{
    const QScopedValueRollback isListing(m_isListing, true);
    const QListWidgetItem *before = m_cards->currentItem();
    const QString chosen = before ? before->data(Qt::UserRole).toString() : QString();
    const int row = m_cards->currentRow();
    m_cards->clear();
    for (const KeptExperiment &kept : m_gallery.all()) {
        QPixmap picture(galleryPicture);
        picture.fill(m_theme.tokens().sunk);
        if (!kept.picture.isNull())
            picture = QPixmap::fromImage(kept.picture);
        auto *card = new QListWidgetItem(QIcon(picture), kept.title, m_cards);
        card->setFlags(card->flags() | Qt::ItemIsEditable);
        card->setData(Qt::UserRole, kept.file);
        card->setToolTip(tr("%1, kept %2. Return opens it.").arg(kept.title, timeOf(kept.when)));
        card->setData(Qt::AccessibleDescriptionRole, card->toolTip());
        if (kept.file == chosen)
            m_cards->setCurrentItem(card);
    }
    if (!m_cards->currentItem() && m_cards->count() > 0)
        m_cards->setCurrentRow(std::clamp(row, 0, m_cards->count() - 1));
    m_empty->setVisible(m_cards->count() == 0);
    refreshButtons();
}

void GalleryPage::refreshButtons()
{
    for (QPushButton *button : {m_open, m_rename, m_remove})
        button->setEnabled(selected());
    const QString undoable = m_gallery.undoText();
    m_undo->setEnabled(!undoable.isEmpty());
    m_undo->setToolTip(undoable.isEmpty() ? tr("There is nothing to undo") : tr("%1 (Ctrl+Z)").arg(undoable));
    QStringList sentences = m_gallery.mistakes();
    if (!m_failure.isEmpty())
        sentences.prepend(m_failure);
    m_mistakes->setText(sentences.join('\n'));
    m_mistakes->setVisible(!sentences.isEmpty());
}

const KeptExperiment *GalleryPage::selected() const
{
    const QListWidgetItem *card = m_cards->currentItem();
    if (!card)
        return nullptr;
    const auto &all = m_gallery.all();
    const auto found = std::find_if(all.begin(), all.end(), [&](const KeptExperiment &one) {
        return one.file == card->data(Qt::UserRole).toString();
    });
    return found == all.end() ? nullptr : &*found;
}

void GalleryPage::openSelected()
{
    if (const KeptExperiment *kept = selected()) {
        const KeptExperiment copy = *kept;
        accept();
        emit opens(copy);
    }
}

void GalleryPage::renameSelected()
{
    if (QListWidgetItem *card = m_cards->currentItem()) {
        m_cards->setFocus();
        m_cards->editItem(card);
    }
}

void GalleryPage::removeSelected()
{
    if (const KeptExperiment *kept = selected())
        attemptChange([this, file = kept->file] { m_gallery.remove(file); });
}

void GalleryPage::undo()
{
    attemptChange([this] { m_gallery.undo(); });
}

void GalleryPage::attemptChange(const std::function<void()> &action)
{
    m_failure.clear();
    try {
        action();
    } catch (const UserError &error) {
        m_failure = error.sentence();
        refreshButtons();
    }
}

bool GalleryPage::eventFilter(QObject *watched, QEvent *event)
{
    // While a title is edited, its field passes on Return.
    if (event->type() != QEvent::KeyPress || QApplication::focusWidget() != m_cards)
        return QDialog::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)
        openSelected();
    else if (key->key() == Qt::Key_F2)
        renameSelected();
    else if (key->key() == Qt::Key_Delete)
        removeSelected();
    else if (key->matches(QKeySequence::Undo))
        undo();
    else
        return QDialog::eventFilter(watched, event);
    return true;
}

}
