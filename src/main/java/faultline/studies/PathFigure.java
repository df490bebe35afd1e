package faultline.studies;

import faultline.geometry.Vector2;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.PixelRectangle;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.FigureNumbers;
import faultline.world.Collision;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.Locale;

/** Fig. 5: the path of the robot in an environment, of which a part is shown, metres. */
record PathFigure(String name, String title, String scenario, Rectangle2D bounds) implements Figure {

    private static final int WIDTH = 560;
    private static final double MARGIN = 16;
    private static final double FOOTER = 24;

    private static final String CAPTION =
            """
            %s: scenarios/%s, seed %d (n\u00a0=\u00a01 run). Line: the path of the robot's centre; pale robot: the \
            start; dark: the end%s; grey: obstacles. %s.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        RunTrace trace = RunTrace.simulate(StudyScenarios.load(scenario).setup());
        double scale = (WIDTH - 2 * MARGIN) / bounds.getWidth();
        double height = scale * bounds.getHeight();
        FigureCanvas canvas = new FigureCanvas(WIDTH, (int) Math.ceil(height + 2 * MARGIN + FOOTER), caption(trace));
        PlanView plan = canvas.addPlan(new PixelRectangle(MARGIN, MARGIN, WIDTH - 2 * MARGIN, height), bounds);
        plan.drawWorld(trace.setup().world());
        plan.drawLine(trace.path(), FigureCanvas.PATH_LINE);
        plan.drawRobot(trace.setup().robot(), trace.setup().start(), 0.4);
        plan.drawRobot(trace.setup().robot(), trace.lastPose(), 1);
        trace.result().collision().ifPresent(collision -> plan.drawRing(collision.point(), 7));
        plan.drawLabel(
                "start", trace.setup().start().position().plus(new Vector2(0.1, -0.3)), 0, 0, FigureCanvas.SMALL_TEXT);
        plan.drawScaleBar(1, WIDTH - 2 * MARGIN, height + 24);
        folder.writeSvg(name, canvas.surface());
    }

    private String caption(RunTrace trace) {
        String ring = trace.result().collision().isPresent() ? "; ring: the contact" : "";
        return String.format(
                Locale.ROOT, CAPTION, title, scenario, trace.setup().seed(), ring, resultText(trace));
    }

    private static String resultText(RunTrace trace) {
        return trace.result()
                .collision()
                .map(PathFigure::collisionText)
                .orElseGet(() -> "After " + FigureNumbers.format(trace.result().simulatedSeconds(), 0)
                        + " s the coverage of the wall is "
                        + FigureNumbers.format(100 * trace.result().coverage().orElse(0), 1)
                        + " %, and the distance error on straight walls "
                        + FigureNumbers.format(
                                1000 * trace.result().distanceRms().orElse(Double.NaN), 2) + " mm RMS");
    }

    private static String collisionText(Collision collision) {
        return "It runs into the " + collision.obstacle() + " after " + FigureNumbers.format(collision.time(), 2)
                + " s";
    }
}
