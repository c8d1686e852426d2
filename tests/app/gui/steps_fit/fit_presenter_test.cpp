#include "app/gui/steps/fit_presenter.h"
#include "tests/app/gui/steps_fit/document_fixture.h"

using namespace straightedge;
using namespace straightedge::gui;
using gui::testing::OpenDocument;

namespace {

angle::ModelName named(const char* text) { return gui::testing::valueOf(angle::parseModelName(text)); }

} // namespace

class FitPresenterTest : public QObject {
  Q_OBJECT

private slots:
  void saysWhatToDoWithoutData();
  void showsEveryView();
  void addsAndRemovesModels();
  void refusesWhatCannotBeFitted();
  void hidesAModelInThePlotsOnly();
  void choosesTheCurve();
  void followsUndo();
};

void FitPresenterTest::saysWhatToDoWithoutData() {
  OpenDocument open;
  const FitPresenter presenter(open.document);
  QVERIFY(presenter.missing().contains("capture"));
  for (const FitView view : FitPresenter::views()) {
    QVERIFY(!FitPresenter::viewTitle(view).isEmpty());
    QCOMPARE(presenter.upperFigure(view).note, presenter.missing());
    QVERIFY(!presenter.lowerFigure(view));
  }
  QCOMPARE(presenter.modelsTable().rows.size(), 3);
}

void FitPresenterTest::showsEveryView() {
  OpenDocument open;
  QVERIFY(open.load());
  const FitPresenter presenter(open.document);
  QCOMPARE(presenter.missing(), QString());
  for (const FitView view : FitPresenter::views()) {
    QVERIFY2(!presenter.upperFigure(view).series.isEmpty(), qPrintable(FitPresenter::viewTitle(view)));
  }
  QCOMPARE(presenter.upperFigure(FitView::CurveAndModels).series.size(), 5);
  QCOMPARE(presenter.lowerFigure(FitView::CurveAndModels)->series.size(), 3);
  QCOMPARE(presenter.lowerFigure(FitView::Harmonics)->y.title, QStringLiteral("Phase (rad)"));
  QVERIFY(presenter.curveText().startsWith("Periodic cubic spline through 32 points."));
  QVERIFY(!presenter.warnings().isEmpty()); // linear:32 is more accurate than 32 points support
}

void FitPresenterTest::addsAndRemovesModels() {
  OpenDocument open;
  QVERIFY(open.load());
  FitPresenter presenter(open.document);
  presenter.addModel(named("linear:16@minimax/12"));
  QCOMPARE(presenter.models().size(), std::size_t{4});
  QCOMPARE(presenter.modelsTable().rows.last().first(), QStringLiteral("linear:16@minimax/12"));
  QCOMPARE(presenter.modelsTable().rows.last().last(), QStringLiteral("–")); // not fitted yet
  QVERIFY(open.settle());
  QVERIFY(presenter.modelsTable().rows.last()[3].toDouble() > 0.0);
  QCOMPARE(presenter.upperFigure(FitView::CurveAndModels).series.size(), 6);
  QCOMPARE(presenter.addProblem(named("linear:16@minimax/12")),
           QStringLiteral("linear:16@minimax/12 is in the list already."));
  presenter.selectModel(3);
  QCOMPARE(presenter.selectedModel(), 3);
  presenter.removeModel(3);
  QCOMPARE(presenter.models().size(), std::size_t{3});
  QCOMPARE(presenter.selectedModel(), 0); // Verify falls back to the first
}

void FitPresenterTest::refusesWhatCannotBeFitted() {
  OpenDocument open;
  QVERIFY(open.load());
  FitPresenter presenter(open.document);
  QVERIFY(presenter.addProblem(named("harmonic:17")).contains("resolve 16"));
  presenter.addModel(named("harmonic:17"));
  QCOMPARE(presenter.models().size(), std::size_t{3});
  angle::ModelName wrong = named("lut:64");
  wrong.size = 5000;
  QVERIFY(!presenter.addProblem(wrong).isEmpty());
  QCOMPARE(presenter.addProblem(named("harmonic:16")), QString());
}

void FitPresenterTest::hidesAModelInThePlotsOnly() {
  OpenDocument open;
  QVERIFY(open.load());
  FitPresenter presenter(open.document);
  QSignalSpy changed(&presenter, &FitPresenter::changed);
  presenter.setShown(1, false);
  QCOMPARE(changed.count(), 1);
  QVERIFY(!presenter.isShown(1));
  const PlotSpec spec = presenter.upperFigure(FitView::CurveAndModels);
  QCOMPARE(spec.series[3].name, QStringLiteral("32 segments"));
  QVERIFY(!spec.series[3].visible);
  QVERIFY(spec.series[2].visible && spec.series[4].visible);
  QCOMPARE(presenter.modelsTable().rows.size(), 3);
  QVERIFY(!open.document.undoStack().canUndo() || open.document.undoStack().undoText() == QLatin1String("Import"));
}

void FitPresenterTest::choosesTheCurve() {
  OpenDocument open;
  QVERIFY(open.load());
  FitPresenter presenter(open.document);
  presenter.setCurveMethod(angle::CurveMethod::Regress);
  QCOMPARE(presenter.curveMethod(), angle::CurveMethod::Regress);
  QVERIFY(QTest::qWaitFor([&] { return presenter.curveText().startsWith("Least squares"); }, gui::testing::patienceMs));
  QVERIFY(presenter.curveText().contains("cross-validation"));
}

void FitPresenterTest::followsUndo() {
  OpenDocument open;
  QVERIFY(open.load());
  FitPresenter presenter(open.document);
  presenter.addModel(named("lut:128"));
  open.document.undoStack().undo();
  QCOMPARE(presenter.models().size(), std::size_t{3});
  open.document.undoStack().redo();
  QCOMPARE(presenter.models().size(), std::size_t{4});
}

QTEST_GUILESS_MAIN(FitPresenterTest)
#include "fit_presenter_test.moc"
