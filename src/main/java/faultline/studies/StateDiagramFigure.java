package faultline.studies;

import faultline.control.FollowerState;
import faultline.control.wallfollower.StateDiagram;
import faultline.control.wallfollower.StateDiagram.Arrow;
import faultline.geometry.Vector2;
import faultline.paint.chart.StateDiagramLayout;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.SvgSurface;
import faultline.paint.surface.TextStyle.Anchor;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.io.IOException;
import java.util.List;

/** Fig. 8: the state diagram of the follower's transition table, with the layout of the window. */
final class StateDiagramFigure implements Figure {

    private static final LineStyle BOX_STYLE = LineStyle.solid(FigureCanvas.FOREGROUND, 1.6);
    private static final LineStyle ARROW_STYLE =
            LineStyle.solid(FigureCanvas.THEME.series().get(0), 1.4);
    private static final double ARROWHEAD_LENGTH = 8;
    private static final PixelRectangle DIAGRAM_AREA = new PixelRectangle(0, 50, 440, 280);
    private static final int WIDTH = 860;
    private static final int HEIGHT = 400;
    private static final double LEGEND_X = 460;
    private static final double ROW_HEIGHT = 31;

    private static final String CAPTION =
            """
            Fig. 8. The states of the wall follower (boxes) and its transitions (arrows), from the table that the \
            follower obeys. Dot: where it begins. Numbers: the order in which conditions are tried; the list on the \
            right names them.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        FigureCanvas canvas = new FigureCanvas(WIDTH, HEIGHT, CAPTION);
        StateDiagramLayout layout = new StateDiagramLayout(DIAGRAM_AREA);
        List<Arrow> arrows = StateDiagram.TRANSITIONS;
        arrows.forEach(arrow -> layout.route(arrow).paint(canvas.surface(), ARROW_STYLE, ARROWHEAD_LENGTH));
        for (FollowerState state : FollowerState.values()) {
            drawState(canvas, layout.box(state), state);
        }
        for (int i = 0; i < arrows.size(); i++) {
            drawNumber(canvas, layout.route(arrows.get(i)).middle(), i + 1);
            drawLegendEntry(canvas, arrows.get(i), i);
        }
        drawInitialMarker(canvas.surface(), layout.box(StateDiagram.INITIAL_STATE));
        folder.writeSvg("fig8-states", canvas.surface());
    }

    private static void drawState(FigureCanvas canvas, Rectangle2D box, FollowerState state) {
        RoundRectangle2D outline =
                new RoundRectangle2D.Double(box.getX(), box.getY(), box.getWidth(), box.getHeight(), 12, 12);
        canvas.surface().fill(outline, FigureCanvas.THEME.classes().get(0));
        canvas.surface().draw(outline, BOX_STYLE);
        canvas.addText(
                state.name(),
                box.getCenterX(),
                box.getCenterY() + 4,
                FigureCanvas.TEXT_STYLE.withBold().withAnchor(Anchor.MIDDLE));
    }

    private static void drawNumber(FigureCanvas canvas, Vector2 at, int number) {
        canvas.surface().fill(Shapes.circle(at, 9), FigureCanvas.THEME.palette().canvas());
        canvas.surface().draw(Shapes.circle(at, 9), LineStyle.solid(ARROW_STYLE.colour(), 1));
        canvas.addText(String.valueOf(number), at.x(), at.y() + 4, FigureCanvas.SMALL_TEXT.withAnchor(Anchor.MIDDLE));
    }

    /** Draws a dot and an arrow from above to the box of the state in which the follower begins. */
    private static void drawInitialMarker(SvgSurface surface, Rectangle2D box) {
        Vector2 tip = new Vector2(box.getX() + 14, box.getY());
        Vector2 dot = tip.minus(new Vector2(0, 26));
        surface.fill(Shapes.circle(dot, 5), BOX_STYLE.colour());
        surface.draw(Shapes.polyline(List.of(dot, tip)), BOX_STYLE);
        surface.fill(Shapes.arrowhead(tip, new Vector2(0, 1), ARROWHEAD_LENGTH, ARROWHEAD_LENGTH), BOX_STYLE.colour());
    }

    private static void drawLegendEntry(FigureCanvas canvas, Arrow arrow, int index) {
        double y = 40 + ROW_HEIGHT * index;
        canvas.addText(
                String.valueOf(index + 1),
                LEGEND_X + 16,
                y,
                FigureCanvas.TEXT_STYLE.withBold().withAnchor(Anchor.END));
        canvas.addText(arrow.from() + " \u2192 " + arrow.to(), LEGEND_X + 26, y, FigureCanvas.SMALL_TEXT);
        canvas.addText(arrow.condition(), LEGEND_X + 165, y, FigureCanvas.SMALL_TEXT);
    }
}
