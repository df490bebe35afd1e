package faultline.app.figures;

import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Plan;
import faultline.world.Collision;
import faultline.world.WorldSpec;
import java.awt.geom.Rectangle2D;
import java.io.IOException;

/**
 * Fig. 5: the path of the robot in an environment.
 *
 * @param name of the file
 * @param scenario that is run
 * @param bounds the part that is shown, metres
 */
record Environment(String name, String scenario, Rectangle2D bounds) implements Figure {

    private static final int WIDTH = 560;
    private static final double MARGIN = 16;
    private static final double FOOT = 46;

    @Override
    public void make(FigureFolder folder) throws IOException {
        Journey journey = Journey.of(Shipped.load(scenario).setup());
        double scale = (WIDTH - 2 * MARGIN) / bounds.getWidth();
        double height = scale * bounds.getHeight();
        Sheet sheet = new Sheet(WIDTH, (int) Math.ceil(height + 2 * MARGIN + FOOT));
        Plan plan = sheet.plan(new Area(MARGIN, MARGIN, WIDTH - 2 * MARGIN, height), bounds);
        WorldSpec world = journey.setup().world();
        if (world.enclosed()) {
            plan.enclosure(world.width(), world.height());
        }
        world.obstacles().forEach(plan::obstacle);
        plan.line(journey.path(), Sheet.PATH);
        plan.robot(journey.setup().robot(), journey.setup().start(), 0.4);
        plan.robot(journey.setup().robot(), journey.last(), 1);
        journey.result().collision().ifPresent(collision -> plan.ring(collision.point(), 7));
        plan.label("start", journey.setup().start().position().plus(new Vec(0.1, -0.3)), 0, 0, Sheet.SMALL);
        plan.scaleBar(bounds.getWidth() > 5 ? 1 : 0.5, WIDTH - 2 * MARGIN, height + 40);
        sheet.text(numbers(journey), MARGIN, height + MARGIN + 40, Sheet.TEXT);
        folder.svg(name, sheet.drawing());
    }

    private static String numbers(Journey journey) {
        return journey.result().collision().map(Environment::end).orElseGet(() -> Numbers.text(journey.result().simulatedSeconds(), 0)
                + " s; coverage of the wall "
                + Numbers.text(100 * journey.result().coverage().orElse(0), 1) + " %; distance error "
                + Numbers.text(1000 * journey.result().distanceRms().orElse(Double.NaN), 2) + " mm RMS");
    }

    private static String end(Collision collision) {
        return "runs into the " + collision.obstacle() + " after " + Numbers.text(collision.time(), 2) + " s";
    }
}
