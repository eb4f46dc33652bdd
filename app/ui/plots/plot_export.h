#pragma once

#include "app/model/number_table.h"
#include "app/ui/theme/theme.h"

#include <QImage>
#include <QPointer>
#include <QSize>

#include <functional>

class QAction;
class QCPPainter;
class QMenu;
class QToolButton;

namespace app {

/// A plot as it is saved: what it is called, and what draws it.
struct PlotPicture
{
    QString title;
    QString fileName; ///< without a suffix
    QSize size;       ///< px
    std::function<void(QCPPainter &)> draw;
};

/// Saves and copies a plot: as a picture, and where it has numbers, as those. One for each plot; its actions go into
/// the plot's menus.
class PlotExport : public QObject
{
    Q_OBJECT

public:
    using MakePicture = std::function<PlotPicture()>;
    using MakeNumbers = std::function<std::optional<NumberSheet>()>;
    using MakeText = std::function<QByteArray()>;

    /// `parent` shows the dialogs, and owns this.
    PlotExport(MakePicture picture, const Theme &theme, QWidget *parent);
    /// Lets the numbers be saved, too. What they come from may have none at times.
    void setNumbers(MakeNumbers numbers);
    /// The same where they need not be computed: the whole table as comma-separated text; empty where there is none.
    void setNumbersAsText(MakeText text);

    void addTo(QMenu &menu);
    /// A button with a menu of all this.
    QToolButton *makeButton(QWidget *parent);
    void addContextMenu(QWidget &plot);
    /// As PNG, SVG or PDF, by the name's ending; a name without one of these becomes a PNG. Returns whether it was
    /// written.
    bool savePicture(QString path);
    void copyPicture();
    /// Writes them, or begins to: see NumberTable.
    void saveNumbers(const QString &path);
    /// What is being written; null if nothing is.
    NumberTable *table() const { return m_table; }

signals:
    /// What was done, or why it was not; one sentence.
    void said(const QString &sentence);
    void failed(const QString &sentence);
    /// Numbers began to be written, or are no more.
    void tableChanged();

private:
    void addNumbersAction(const QString &tip);
    void askPicture();
    void askNumbers();
    void saveText(const QString &path);
    void computeNumbers(const QString &path);
    /// Puts a file in its place. Returns whether that went well; said either way.
    bool commit(const QString &path, const QString &failure, const std::function<bool(QIODevice &)> &write);
    QImage image() const;
    bool write(QIODevice &file, const QString &suffix) const;
    void paint(QCPPainter &painter, const PlotPicture &picture) const;
    QWidget *window() const;

    MakePicture m_picture;
    MakeNumbers m_numbers;
    MakeText m_text;
    const Theme &m_theme;
    QAction *m_savePicture;
    QAction *m_copyPicture;
    QAction *m_saveNumbers = nullptr;
    QPointer<NumberTable> m_table;
};

}
