#include "app/gui/steps/fit_step.h"

#include "app/gui/steps/model_chooser.h"
#include "app/gui/steps/model_list.h"
#include "app/gui/steps/notice_list.h"

#include <QComboBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace straightedge::gui {

FitStep::FitStep(StepContext context, QWidget* parent) : StepPage(parent), m_presenter(context.document) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeSide());
  auto* right = new QSplitter(Qt::Vertical, this);
  right->setChildrenCollapsible(false);
  right->addWidget(makePlots());
  right->addWidget(makeModels());
  right->setStretchFactor(0, 4);
  right->setStretchFactor(1, 1);
  columns->addWidget(right, 1);
  connect(&m_presenter, &FitPresenter::changed, this, &FitStep::refresh);
  connect(&m_presenter, &FitPresenter::changed, this, &StepPage::availabilityChanged);
}

QString FitStep::title() const { return tr("Fit"); }

QString FitStep::helpPage() const { return QStringLiteral("fit"); }

QString FitStep::missing() const { return m_presenter.missing(); }

void FitStep::entered() {
  m_shown = true;
  if (m_stale) {
    refresh();
  }
}

void FitStep::left() { m_shown = false; }

QWidget* FitStep::makeSide() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);

  auto* curve = new QGroupBox(tr("Correction curve"), content);
  auto* curveLayout = new QVBoxLayout(curve);
  m_curve = new QComboBox(curve);
  m_curve->setObjectName(QStringLiteral("curveMethod"));
  m_curve->addItem(tr("Automatic"), static_cast<int>(angle::CurveMethod::Auto));
  m_curve->addItem(tr("Interpolate: through every point"), static_cast<int>(angle::CurveMethod::Interpolate));
  m_curve->addItem(tr("Regress: for noisy or repeated points"), static_cast<int>(angle::CurveMethod::Regress));
  m_curve->setItemData(0, tr("Regression where readings repeat or step back, otherwise interpolation"),
                       Qt::ToolTipRole);
  m_curve->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_curveText = new QLabel(curve);
  m_curveText->setObjectName(QStringLiteral("curveText"));
  m_curveText->setWordWrap(true);
  m_curveText->setTextInteractionFlags(Qt::TextSelectableByMouse);
  curveLayout->addWidget(m_curve);
  curveLayout->addWidget(m_curveText);
  column->addWidget(curve);

  auto* add = new QGroupBox(tr("Another model"), content);
  auto* addLayout = new QVBoxLayout(add);
  m_chooser = new ModelChooser([this](const angle::ModelName& name) { return m_presenter.addProblem(name); }, add);
  addLayout->addWidget(m_chooser);
  column->addWidget(add);
  column->addStretch(1);
  auto* next = new QPushButton(tr("Go on to Compare"), content);
  next->setObjectName(QStringLiteral("goToCompare"));
  column->addWidget(next);

  connect(m_curve, &QComboBox::activated, this,
          [this] { m_presenter.setCurveMethod(static_cast<angle::CurveMethod>(m_curve->currentData().toInt())); });
  connect(m_chooser, &ModelChooser::addRequested, &m_presenter, &FitPresenter::addModel);
  connect(next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Compare")); });

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(fontMetrics().averageCharWidth() * 44);
  return scroll;
}

QWidget* FitStep::makePlots() {
  auto* area = new QWidget(this);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* bar = new QHBoxLayout;
  m_view = new QComboBox(area);
  m_view->setObjectName(QStringLiteral("fitView"));
  for (const FitView each : FitPresenter::views()) {
    m_view->addItem(FitPresenter::viewTitle(each), static_cast<int>(each));
  }
  auto* caption = new QLabel(tr("S&how"), area);
  caption->setBuddy(m_view);
  m_magnifier = new QToolButton(area);
  m_magnifier->setObjectName(QStringLiteral("magnifier"));
  m_magnifier->setText(tr("Magnifier"));
  m_magnifier->setToolTip(tr("A lens beside the pointer shows how the models differ"));
  m_magnifier->setCheckable(true);
  bar->addWidget(caption);
  bar->addWidget(m_view);
  bar->addStretch(1);
  bar->addWidget(m_magnifier);
  layout->addLayout(bar);
  m_plots = new QSplitter(Qt::Vertical, area);
  m_plots->setChildrenCollapsible(false);
  m_upper = new PlotView(m_plots);
  m_upper->setObjectName(QStringLiteral("upperPlot"));
  m_upper->setMinimumHeight(160);
  m_lower = new PlotView(m_plots);
  m_lower->setObjectName(QStringLiteral("lowerPlot"));
  m_lower->setMinimumHeight(130);
  m_plots->addWidget(m_upper);
  m_plots->addWidget(m_lower);
  m_plots->setStretchFactor(0, 3);
  m_plots->setStretchFactor(1, 2);
  layout->addWidget(m_plots, 1);
  connect(m_view, &QComboBox::currentIndexChanged, this, &FitStep::showPlots);
  connect(m_magnifier, &QToolButton::toggled, this, [this](bool on) {
    m_upper->setMagnifier(on);
    m_lower->setMagnifier(on);
  });
  return area;
}

QWidget* FitStep::makeModels() {
  auto* area = new QWidget(this);
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* bar = new QHBoxLayout;
  bar->addWidget(new QLabel(tr("Chosen models; errors in degrees"), area));
  bar->addStretch(1);
  m_remove = new QPushButton(tr("&Remove"), area);
  m_remove->setObjectName(QStringLiteral("removeModel"));
  m_copy = new QPushButton(tr("Co&py table"), area);
  m_copy->setObjectName(QStringLiteral("copyModels"));
  bar->addWidget(m_remove);
  bar->addWidget(m_copy);
  layout->addLayout(bar);
  m_models = new ModelList(m_presenter, area);
  m_models->setMinimumHeight(110);
  layout->addWidget(m_models, 1);
  connect(m_models, &QTableWidget::itemSelectionChanged, this,
          [this] { m_remove->setEnabled(m_models->currentRow() >= 0 && m_models->rowCount() > 1); });
  connect(m_remove, &QPushButton::clicked, this, [this] { m_presenter.removeModel(m_models->currentRow()); });
  connect(m_copy, &QPushButton::clicked, m_models, &ResultTable::copy);
  m_remove->setEnabled(false);
  return area;
}

FitView FitStep::view() const { return static_cast<FitView>(m_view->currentData().toInt()); }

void FitStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  {
    const QSignalBlocker quiet(m_curve);
    m_curve->setCurrentIndex(m_curve->findData(static_cast<int>(m_presenter.curveMethod())));
  }
  m_curveText->setText(m_presenter.curveText());
  m_curveText->setVisible(!m_presenter.curveText().isEmpty());
  QList<Notice> notices;
  if (const QString missing = m_presenter.missing(); !missing.isEmpty()) {
    notices.append({Notice::Level::Information, missing});
  }
  for (const QString& warning : m_presenter.warnings()) {
    notices.append({Notice::Level::Warning, warning});
  }
  m_notices->setNotices(notices);
  m_chooser->refresh();
  m_models->refresh();
  m_remove->setEnabled(m_models->currentRow() >= 0 && m_models->rowCount() > 1);
  showPlots();
}

void FitStep::showPlots() {
  m_upper->setSpec(m_presenter.upperFigure(view()));
  const std::optional<PlotSpec> lower = m_presenter.lowerFigure(view());
  m_lower->setVisible(lower.has_value());
  if (lower) {
    m_lower->setSpec(*lower);
  }
}

StepPage* makeFitStep(StepContext context, QWidget* parent) { return new FitStep(context, parent); }

} // namespace straightedge::gui
