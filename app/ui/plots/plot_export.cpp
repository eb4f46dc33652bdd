#include "app/ui/plots/plot_export.h"

#include "app/model/text/quoting.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/theme/icon_button.h"

#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QSaveFile>
#include <QToolButton>

namespace app {

PlotExport::PlotExport(MakePicture picture, const Theme &theme, QWidget *parent)
    : QObject(parent), m_picture(std::move(picture)), m_theme(theme),
      m_savePicture(new QAction(tr("Save the &picture…"), this)),
      m_copyPicture(new QAction(tr("&Copy the picture"), this))
{
    m_savePicture->setToolTip(tr("As PNG, SVG or PDF"));
    connect(m_savePicture, &QAction::triggered, this, &PlotExport::askPicture);
    connect(m_copyPicture, &QAction::triggered, this, &PlotExport::copyPicture);
}

void PlotExport::setNumbers(MakeNumbers numbers)
{
    m_numbers = std::move(numbers);
    addNumbersAction(tr("Every frame of the run, with all digits"));
}

void PlotExport::setNumbersAsText(MakeText text)
{
    m_text = std::move(text);
    addNumbersAction(tr("All values that are counted or measured here, with all digits"));
}

void PlotExport::addNumbersAction(const QString &tip)
{
    m_saveNumbers = new QAction(tr("Save the &numbers as CSV…"), this);
    m_saveNumbers->setToolTip(tip);
    connect(m_saveNumbers, &QAction::triggered, this, &PlotExport::askNumbers);
}

void PlotExport::addTo(QMenu &menu)
{
    if (m_saveNumbers)
        menu.addAction(m_saveNumbers);
    menu.addActions({m_savePicture, m_copyPicture});
}

void PlotExport::addContextMenu(QWidget &plot)
{
    plot.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&plot, &QWidget::customContextMenuRequested, this, [this, shown = &plot](const QPoint &place) {
        auto *menu = new QMenu(shown);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->setToolTipsVisible(true);
        addTo(*menu);
        menu->popup(shown->mapToGlobal(place));
    });
}

QToolButton *PlotExport::makeButton(QWidget *parent)
{
    QToolButton *button = makeIconButton("plotMenu", "more", m_theme, parent);
    auto *menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    addTo(*menu);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(tr("Save or copy this plot"));
    button->setAccessibleName(tr("Save or copy this plot"));
    return button;
}

QWidget *PlotExport::window() const
{
    return static_cast<QWidget *>(parent())->window();
}

bool PlotExport::write(QIODevice &file, const QString &suffix) const
{
    if (suffix == "png")
        return imageOf(m_picture(), m_theme).save(&file, "PNG");
    return suffix == "pdf" ? writePdf(file, m_picture(), m_theme) : writeSvg(file, m_picture(), m_theme);
}

bool PlotExport::savePicture(QString path)
{
    QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix != "png" && suffix != "svg" && suffix != "pdf") {
        suffix = QStringLiteral("png");
        path += ".png";
    }
    return commit(path,
                  tr("Could not save the picture as %1: %2. Choose another folder, or free some disk space."),
                  [&](QIODevice &file) { return write(file, suffix); });
}

bool PlotExport::commit(const QString &path, const QString &failure,
                        const std::function<bool(QIODevice &)> &write)
{
    const QString name = quoted(QFileInfo(path).fileName());
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && write(file) && file.commit()) {
        emit messageRequested(tr("Saved as %1.").arg(name));
        return true;
    }
    emit failed(failure.arg(name, oneLine(file.errorString())));
    return false;
}

void PlotExport::copyPicture()
{
    QGuiApplication::clipboard()->setImage(imageOf(m_picture(), m_theme));
    emit messageRequested(tr("The picture is copied: paste it anywhere."));
}

void PlotExport::askPicture()
{
    const QString path = askWhereToSave(window(), tr("Save the picture"), m_picture().fileName + ".png",
                                        tr("Pictures (*.png *.svg *.pdf)"));
    if (!path.isEmpty())
        savePicture(path);
}

void PlotExport::askNumbers()
{
    const QString path =
        askWhereToSave(window(), tr("Save the numbers"), m_picture().fileName + ".csv", tr("Tables (*.csv)"));
    if (!path.isEmpty())
        saveNumbers(path);
}

void PlotExport::saveNumbers(const QString &path)
{
    m_text ? saveText(path) : computeNumbers(path);
}

void PlotExport::saveText(const QString &path)
{
    const QByteArray text = m_text();
    if (text.isEmpty()) {
        emit failed(tr("There are no numbers to save, because this plot is empty. Play the run first."));
        return;
    }
    commit(path, tr("Could not save the numbers as %1: %2. Choose another folder, or free some disk space."),
           [&text](QIODevice &file) { return file.write(text) == text.size(); });
}

void PlotExport::computeNumbers(const QString &path)
{
    std::optional<NumberSheet> sheet = m_numbers ? m_numbers() : std::nullopt;
    if (!sheet) {
        emit failed(tr("There are no numbers to save, because this plot is empty. Play the run first."));
        return;
    }
    if (m_table)
        m_table->cancel();
    m_table = new NumberTable(std::move(*sheet), path, this);
    NumberTable *table = m_table;
    const auto finish = [this, table] {
        table->deleteLater();
        if (m_table == table)
            m_table.clear();
        emit tableChanged();
    };
    connect(table, &NumberTable::written, this, [this, finish](const QString &file) {
        emit messageRequested(tr("Saved as %1.").arg(quoted(QFileInfo(file).fileName())));
        finish();
    });
    connect(table, &NumberTable::failed, this, [this, finish](const QString &sentence) {
        emit failed(sentence);
        finish();
    });
    connect(table, &NumberTable::cancelled, this, [this, finish] {
        emit messageRequested(tr("Cancelled: nothing was saved."));
        finish();
    });
    emit tableChanged();
}

}
