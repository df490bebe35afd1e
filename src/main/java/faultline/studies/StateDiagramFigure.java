package faultline.studies;

import faultline.control.FollowerState;
import faultline.control.StateDiagram;
import faultline.control.StateDiagram.Arrow;
import faultline.geometry.Vector2;
import faultline.paint.surface.Arrowhead;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.SvgDrawing;
import faultline.paint.surface.TextStyle.Anchor;
import java.io.IOException;
import java.util.List;

/** Fig. 8: the state diagram, laid out from the table that the follower itself obeys. */
final class StateDiagramFigure implements Figure {

    private static final LineStyle BOX_STYLE = LineStyle.solid(FigureCanvas.FOREGROUND, 1.6);
    private static final LineStyle LINE_STYLE =
            LineStyle.solid(FigureCanvas.THEME.series().get(0), 1.4);
    private static final double RADIUS = 38;
    private static final int FIGURE_SIZE = 400;
    private static final double LEGEND_X = 410;

    @Override
    public void write(FigureFolder folder) throws IOException {
        List<Arrow> arrows = StateDiagram.TRANSITIONS;
        FigureCanvas sheet = new FigureCanvas(800, FIGURE_SIZE);
        CircularStateLayout layout = CircularStateLayout.of(
                arrows, new Vector2(FIGURE_SIZE / 2.0, FIGURE_SIZE / 2.0), FIGURE_SIZE / 2.0 - RADIUS - 14);
        List<List<Vector2>> curves =
                arrows.stream().map(arrow -> layout.curve(arrow, RADIUS)).toList();
        curves.forEach(curve -> draw(sheet.drawing(), curve));
        List<Vector2> numbers = CircularStateLayout.labelPositions(curves);
        for (int i = 0; i < arrows.size(); i++) {
            drawNumber(sheet, numbers.get(i), i + 1);
            drawLegendEntry(sheet, arrows.get(i), i);
        }
        for (FollowerState state : FollowerState.values()) {
            draw(sheet, layout.position(state), state);
        }
        drawInitialMarker(sheet.drawing(), layout.position(StateDiagram.INITIAL_STATE));
        folder.writeSvg("fig8-states", sheet.drawing());
    }

    /** A dot and an arrow from above the state that the follower begins in. */
    private static void drawInitialMarker(SvgDrawing drawing, Vector2 state) {
        Vector2 dot = state.minus(new Vector2(60, RADIUS - 8));
        Vector2 way = state.minus(dot);
        Vector2 tip = state.minus(way.times((RADIUS + 2) / way.length()));
        drawing.fillCircle(dot, 5, BOX_STYLE.colour());
        draw(drawing, List.of(dot, dot.plus(tip).times(0.5), tip));
    }

    private static void draw(SvgDrawing drawing, List<Vector2> curve) {
        drawing.drawPolyline(curve, false, LINE_STYLE);
        Arrowhead.paint(drawing, curve.get(curve.size() - 3), curve.get(curve.size() - 1), LINE_STYLE);
    }

    private static void drawNumber(FigureCanvas sheet, Vector2 at, int number) {
        sheet.drawing().fillCircle(at, 9, FigureCanvas.THEME.palette().canvas());
        sheet.drawing().drawCircle(at, 9, LineStyle.solid(LINE_STYLE.colour(), 1));
        sheet.addText(String.valueOf(number), at.x(), at.y() + 4, FigureCanvas.SMALL_TEXT.withAnchor(Anchor.MIDDLE));
    }

    private static void draw(FigureCanvas sheet, Vector2 at, FollowerState state) {
        sheet.drawing().fillCircle(at, RADIUS, FigureCanvas.THEME.classes().get(0));
        sheet.drawing().drawCircle(at, RADIUS, BOX_STYLE);
        sheet.addText(
                state.name(),
                at.x(),
                at.y() + 4,
                FigureCanvas.TEXT_STYLE.withBold().withAnchor(Anchor.MIDDLE));
    }

    private static void drawLegendEntry(FigureCanvas sheet, Arrow arrow, int index) {
        double y = 40 + 31.0 * index;
        sheet.addText(
                String.valueOf(index + 1),
                LEGEND_X + 16,
                y,
                FigureCanvas.TEXT_STYLE.withBold().withAnchor(Anchor.END));
        sheet.addText(arrow.from() + " \u2192 " + arrow.to(), LEGEND_X + 26, y, FigureCanvas.SMALL_TEXT);
        sheet.addText(arrow.condition(), LEGEND_X + 165, y, FigureCanvas.SMALL_TEXT);
    }
}
