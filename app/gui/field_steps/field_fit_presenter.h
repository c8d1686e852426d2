// What the step Fit of a field calibration says and does, without widgets: choices, blocks, figures, tables.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/figures/field_figures.h"
#include "app/gui/figures/report_content.h"
#include "app/gui/steps/notice_list.h"

#include <QList>
#include <QObject>
#include <QString>

namespace straightedge::gui {

/// GUI thread. Reads the document's results; every change goes through the document and can be undone.
class FieldFitPresenter : public QObject {
  Q_OBJECT
public:
  struct BlockChoice {
    field::Block block = field::Block::Nonlinearity;
    QString title;
    bool on = true;       ///< by choice
    bool measured = true; ///< the campaign has rows for it
    QString cost;         ///< what the calibration lacks without it
  };
  /// Largest error of an axis before and after calibration.
  struct BeforeAfter {
    QString caption, value, hint;
  };

  explicit FieldFitPresenter(FieldDocument& document, QObject* parent = nullptr);

  // Choices
  const FieldChoices& choices() const { return m_document.choices(); }
  void setOrder(int order);
  void setMethod(field::FitMethod method);
  void setFullScaleT(double fullScaleT);
  void setReferenceTemperatureC(double temperatureC);
  QList<BlockChoice> blocks() const; ///< in the chain's order
  void setBlockOn(field::Block block, bool on);
  QString fitText() const; ///< why the order will do, axis by axis; how the joint fit went

  // Results
  QList<NamedFigure> figures() const; ///< empty without a fit
  PlotSpec emptyPlot() const;         ///< says what is missing
  QList<BeforeAfter> beforeAfter() const;
  ReportTable orders() const;
  ReportTable blockRows() const;
  ReportTable coefficients() const;
  ReportTable uncertainty() const; ///< shares of it
  ReportTable states() const;      ///< verification state by state, percent of full scale

  QString missing() const; ///< empty when there is a fit; otherwise what to do
  QList<Notice> notices() const;

signals:
  void changed(); ///< results or choices: read everything anew

private:
  FieldDocument& m_document;
};

} // namespace straightedge::gui
