package faultline.app.figures;

import faultline.control.FollowerState;
import faultline.control.StateDiagram;
import faultline.control.StateDiagram.Arrow;
import faultline.geometry.Vec;
import faultline.paint.plot.Arrowhead;
import faultline.paint.plot.Pen;
import faultline.paint.plot.SvgDrawing;
import faultline.paint.plot.TextStyle.Anchor;
import java.io.IOException;
import java.util.List;

/** Fig. 8: the state diagram, laid out from the table that the follower itself obeys. */
final class StateChart implements Figure {

    private static final Pen BOX = Pen.solid(Sheet.INK, 1.6);
    private static final Pen LINE = Pen.solid(Sheet.THEME.series().get(0), 1.4);
    private static final double RADIUS = 38;
    private static final int SIZE = 400;
    private static final double KEY = 410;

    @Override
    public void make(FigureFolder folder) throws IOException {
        List<Arrow> arrows = StateDiagram.ARROWS;
        Sheet sheet = new Sheet(800, SIZE);
        StateLayout layout = StateLayout.of(arrows, new Vec(SIZE / 2.0, SIZE / 2.0), SIZE / 2.0 - RADIUS - 14);
        List<List<Vec>> curves = arrows.stream().map(arrow -> layout.curve(arrow, RADIUS)).toList();
        curves.forEach(curve -> draw(sheet.drawing(), curve));
        List<Vec> numbers = StateLayout.apart(curves);
        for (int i = 0; i < arrows.size(); i++) {
            number(sheet, numbers.get(i), i + 1);
            key(sheet, arrows.get(i), i);
        }
        for (FollowerState state : FollowerState.values()) {
            draw(sheet, layout.place(state), state);
        }
        begin(sheet.drawing(), layout.place(StateDiagram.FIRST));
        folder.svg("fig8-states", sheet.drawing());
    }

    /** A dot and an arrow from above the state that the follower begins in. */
    private static void begin(SvgDrawing drawing, Vec state) {
        Vec dot = state.minus(new Vec(60, RADIUS - 8));
        Vec way = state.minus(dot);
        Vec tip = state.minus(way.times((RADIUS + 2) / way.length()));
        drawing.disc(dot, 5, BOX.colour());
        draw(drawing, List.of(dot, dot.plus(tip).times(0.5), tip));
    }

    private static void draw(SvgDrawing drawing, List<Vec> curve) {
        drawing.stroke(curve, false, LINE);
        Arrowhead.paint(drawing, curve.get(curve.size() - 3), curve.get(curve.size() - 1), LINE);
    }

    private static void number(Sheet sheet, Vec at, int number) {
        sheet.drawing().disc(at, 9, Sheet.THEME.palette().canvas());
        sheet.drawing().ring(at, 9, Pen.solid(LINE.colour(), 1));
        sheet.text(String.valueOf(number), at.x(), at.y() + 4, Sheet.SMALL.anchored(Anchor.MIDDLE));
    }

    private static void draw(Sheet sheet, Vec at, FollowerState state) {
        sheet.drawing().disc(at, RADIUS, Sheet.THEME.classes().get(0));
        sheet.drawing().ring(at, RADIUS, BOX);
        sheet.text(state.name(), at.x(), at.y() + 4, Sheet.TEXT.inBold().anchored(Anchor.MIDDLE));
    }

    private static void key(Sheet sheet, Arrow arrow, int index) {
        double y = 40 + 31.0 * index;
        sheet.text(String.valueOf(index + 1), KEY + 16, y, Sheet.TEXT.inBold().anchored(Anchor.END));
        sheet.text(arrow.from() + " \u2192 " + arrow.to(), KEY + 26, y, Sheet.SMALL);
        sheet.text(arrow.condition(), KEY + 165, y, Sheet.SMALL);
    }
}
