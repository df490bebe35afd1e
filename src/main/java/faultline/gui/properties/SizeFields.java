package faultline.gui.properties;

import faultline.geometry.Vector2;
import faultline.gui.panel.FormConstraints;
import faultline.gui.panel.NumberSpinner;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.function.Predicate;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The size of an obstacle: two lengths, or points. */
final class SizeFields implements ObstacleShape.ShapeVisitor<SizeFields.Size> {

    private static final double MIN_SIZE = 0.001;
    private static final double MAX_SIZE = 10_000;

    /**
     * The size of a shape.
     *
     * @param kind the last part of the keys of the labels
     * @param first the first length, metres; not a number if there is none
     * @param second the second length, metres; not a number if there is none
     * @param points the points, empty if it has lengths
     */
    record Size(String kind, double first, double second, List<Vector2> points) {}

    private final Predicate<ObstacleShape> onChange;
    private final JLabel firstLabel = new JLabel();
    private final JLabel secondLabel = new JLabel();
    private final NumberSpinner first =
            new NumberSpinner("0.00##", MIN_SIZE, MAX_SIZE, 0.05, value -> change(value, second().doubleValue()));
    private final NumberSpinner second =
            new NumberSpinner("0.00##", MIN_SIZE, MAX_SIZE, 0.05, value -> change(first().doubleValue(), value));
    private final PointsField points = new PointsField("obstacle.points", this::changePoints);
    /** Null if none is shown. */
    private ObstacleShape shape;

    SizeFields(Predicate<ObstacleShape> onChange) {
        this.onChange = onChange;
        RefreshSteps.add(firstLabel, label -> setLabels(kind()));
    }

    private String kind() {
        return shape == null ? "rectangle" : shape.accept(this).kind();
    }

    private NumberSpinner first() {
        return first;
    }

    private NumberSpinner second() {
        return second;
    }

    /** Adds three rows to a form. */
    void addTo(JPanel form, int row) {
        firstLabel.setLabelFor(first);
        secondLabel.setLabelFor(second);
        form.add(firstLabel, FormConstraints.cell(0, row));
        form.add(first.withColumns(8), FormConstraints.cell(1, row));
        form.add(secondLabel, FormConstraints.cell(0, row + 1));
        form.add(second.withColumns(8), FormConstraints.cell(1, row + 1));
        form.add(FormConstraints.label("obstacle.points", points), FormConstraints.cell(0, row + 2));
        form.add(points, FormConstraints.fillRow(1, row + 2));
    }

    private void setLabels(String kind) {
        String key = "obstacle.size." + kind;
        String firstText = Messages.get(key + ".first");
        if (!firstText.equals(firstLabel.getText())) {
            firstLabel.setText(firstText);
            secondLabel.setText(Messages.get(key + ".second"));
            first.withName(key + ".first");
            second.withName(key + ".second");
        }
    }

    private boolean change(double newFirst, double newSecond) {
        if (shape instanceof ObstacleShape.RectangleShape) {
            return onChange.test(new ObstacleShape.RectangleShape(newFirst, newSecond));
        }
        if (shape instanceof ObstacleShape.CircleShape) {
            return onChange.test(new ObstacleShape.CircleShape(newFirst));
        }
        return shape instanceof ObstacleShape.EllipseShape
                && onChange.test(new ObstacleShape.EllipseShape(newFirst, newSecond));
    }

    private boolean changePoints(List<Vector2> entered) {
        try {
            return onChange.test(
                    shape instanceof ObstacleShape.WallShape
                            ? new ObstacleShape.WallShape(entered)
                            : new ObstacleShape.PolygonShape(entered));
        } catch (IllegalArgumentException notAllowed) {
            return false;
        }
    }

    /** Shows a shape, or disabled fields if it is null. */
    void setShape(ObstacleShape shapeOrNull) {
        shape = shapeOrNull;
        Size size = shape == null ? new Size("rectangle", Double.NaN, Double.NaN, List.of()) : shape.accept(this);
        setLabels(size.kind());
        show(first, size.first());
        show(second, size.second());
        points.setEnabled(!size.points().isEmpty());
        points.setPoints(size.points());
    }

    private static void show(NumberSpinner field, double value) {
        field.setEnabled(!Double.isNaN(value));
        field.setWorldValue(value);
    }

    @Override
    public Size visit(ObstacleShape.RectangleShape rectangle) {
        return new Size("rectangle", rectangle.width(), rectangle.height(), List.of());
    }

    @Override
    public Size visit(ObstacleShape.CircleShape circle) {
        return new Size("circle", circle.radius(), Double.NaN, List.of());
    }

    @Override
    public Size visit(ObstacleShape.EllipseShape ellipse) {
        return new Size("ellipse", ellipse.rx(), ellipse.ry(), List.of());
    }

    @Override
    public Size visit(ObstacleShape.PolygonShape polygon) {
        return new Size("rectangle", Double.NaN, Double.NaN, polygon.points());
    }

    @Override
    public Size visit(ObstacleShape.WallShape wall) {
        return new Size("rectangle", Double.NaN, Double.NaN, wall.points());
    }

    @Override
    public Size visit(ObstacleShape.PlanShape plan) {
        return new Size("rectangle", Double.NaN, Double.NaN, List.of());
    }
}
