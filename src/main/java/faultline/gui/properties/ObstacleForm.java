package faultline.gui.properties;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditLimits;
import faultline.gui.edit.ObstacleEditor;
import faultline.gui.form.EnteredTextField;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.CachedDegrees;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.scenario.xml.ScenarioLimits;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** Every attribute of one obstacle. Fields that do not apply to its shape are disabled. */
final class ObstacleForm extends JPanel {

    private static final double MAX_SPEED = 10;
    private static final double RIGHT_ANGLE = 90;
    private static final double USUAL_SPECULAR_ANGLE = 20;
    private static final double USUAL_SPEED = 0.2;
    private static final int ID_COLUMNS = 8;
    /** Fewer than there is room for. */
    private static final int NOTE_COLUMNS = 20;

    private final transient CommandSender sender;
    private final transient ObstacleEditor editor;
    private final EnteredTextField.IdField idField;
    private final NumberSpinner x = coordinate((old, value) -> new Pose(value, old.y(), old.heading()));
    private final NumberSpinner y = coordinate((old, value) -> new Pose(old.x(), value, old.heading()));
    private final NumberSpinner heading = new NumberSpinner(
            "0.##",
            -EditLimits.MAX_ANGLE,
            EditLimits.MAX_ANGLE,
            5,
            value -> move(old -> new Pose(old.x(), old.y(), Degrees.toRadians(value))));
    private final SizeFields size = new SizeFields(shape -> change(old -> old.withShape(shape)));
    private final JCheckBox glossy = UiText.text(new JCheckBox(), "obstacle.glossy");
    private final NumberSpinner specularAngle = new NumberSpinner(
            "0.##", 0.1, RIGHT_ANGLE, 1, value -> change(old -> old.withSpecularAngle(Degrees.toRadians(value))));
    private final NumberSpinner speed = new NumberSpinner(
            "0.00##",
            0,
            MAX_SPEED,
            0.05,
            value -> change(old -> old.withMotion(old.motion().withSpeed(value))));
    private final JCheckBox loop = UiText.text(new JCheckBox(), "obstacle.loop");
    private final PointsField waypoints = new PointsField("obstacle.waypoints", this::changeWaypoints);
    private final JTextArea planNote = UiText.wrappedText();
    private final transient CachedDegrees shownHeading = new CachedDegrees();
    private final transient CachedDegrees shownSpecularAngle = new CachedDegrees();
    /** Null if none is shown. */
    private transient Obstacle obstacle;
    /** The id of the obstacle in the edited scenario, empty for none. */
    private String id = "";

    ObstacleForm(CommandSender sender, ObstacleEditor editor) {
        super(new WrappingGridLayout());
        this.sender = sender;
        this.editor = editor;
        this.idField = new EnteredTextField.IdField("obstacle.id", ID_COLUMNS, editor::rename);
        FormConstraints.addRow(this, 0, "obstacle.id", idField);
        FormConstraints.addRow(this, 1, "obstacle.x", x.withColumns(8));
        FormConstraints.addRow(this, 2, "obstacle.y", y.withColumns(8));
        FormConstraints.addRow(this, 3, "obstacle.heading", heading.withColumns(8));
        size.addTo(this, 4);
        planNote.setColumns(NOTE_COLUMNS);
        RefreshSteps.add(planNote, note -> note.setText(Messages.get("obstacle.plan")));
        add(planNote, FormConstraints.fillRow(0, 12));
        glossy.addActionListener(event -> change(old ->
                old.withSpecularAngle(glossy.isSelected() ? Degrees.toRadians(USUAL_SPECULAR_ANGLE) : Obstacle.MATT)));
        loop.addActionListener(event -> change(old -> old.withMotion(new WaypointPath(
                old.motion().speed(), loop.isSelected(), old.motion().waypoints()))));
        add(glossy, FormConstraints.fillRow(1, 7));
        FormConstraints.addRow(this, 8, "obstacle.specularAngle", specularAngle.withColumns(8));
        FormConstraints.addRow(this, 9, "obstacle.waypoints", waypoints);
        FormConstraints.addRow(this, 10, "obstacle.speed", speed.withColumns(8));
        add(loop, FormConstraints.fillRow(1, 11));
        setObstacle(null, List.of());
    }

    /** Ends what is being typed for the obstacle, which is dropped if that does not exist any more. */
    private void endTyping(boolean exists) {
        Stream<NumberSpinner> numbers = Stream.of(x, y, heading, specularAngle, speed);
        if (exists) {
            numbers.forEach(NumberSpinner::commitPendingEdit);
            waypoints.commitOrRevert();
            size.commitOrRevert();
        } else {
            numbers.forEach(NumberSpinner::discardPendingEdit);
            waypoints.discardPendingEdit();
            size.discardPendingEdits();
        }
    }

    private NumberSpinner coordinate(BiFunction<Pose, Double, Pose> moved) {
        return new NumberSpinner(
                "0.00##",
                -ScenarioLimits.MAX_COORDINATE,
                ScenarioLimits.MAX_COORDINATE,
                0.05,
                value -> move(old -> moved.apply(old, value)));
    }

    private void move(UnaryOperator<Pose> change) {
        if (obstacle != null) {
            Pose expected = sender.pendingEdits().expected(obstacle).pose();
            Pose moved = change.apply(expected);
            if (!moved.equals(expected)) {
                sender.send(new Command.MoveObstacle(obstacle.id(), moved));
            }
        }
    }

    /** Replaces the obstacle by a changed one, and returns whether that is allowed. */
    private boolean change(UnaryOperator<Obstacle> change) {
        if (obstacle == null) {
            return false;
        }
        try {
            Obstacle expected = sender.pendingEdits().expected(obstacle);
            Obstacle changed = change.apply(expected);
            if (!changed.equals(expected)) {
                sender.send(new Command.PlaceObstacle(changed));
            }
            return true;
        } catch (IllegalArgumentException notAllowed) {
            return false;
        }
    }

    private boolean changeWaypoints(List<Vector2> points) {
        return change(old -> old.withMotion(
                points.isEmpty()
                        ? WaypointPath.NONE
                        : new WaypointPath(
                                old.isMoving() ? old.motion().speed() : USUAL_SPEED,
                                old.motion().loop(),
                                points)));
    }

    /**
     * Shows an obstacle as it will be after the commands that were sent, or disabled fields if it is null. What is
     * being typed is first applied to the one before, if it is still among the obstacles.
     */
    void setObstacle(Obstacle obstacleOrNull, List<Obstacle> obstacles) {
        String newId = obstacleOrNull == null ? "" : editor.editedId(obstacleOrNull);
        if (!newId.equals(id)) {
            endTyping(obstacles.stream().map(editor::editedId).anyMatch(id::equals));
        }
        idField.setId(newId);
        id = newId;
        obstacle = obstacleOrNull;
        Optional<Obstacle> shown = Optional.ofNullable(obstacle).map(sender.pendingEdits()::expected);
        Stream.of(x, y, heading, waypoints).forEach(field -> field.setEnabled(shown.isPresent()));
        size.setShape(shown.map(Obstacle::shape).orElse(null));
        planNote.setVisible(shown.filter(now -> now.shape() instanceof ObstacleShape.PlanShape)
                .isPresent());
        glossy.setEnabled(shown.filter(now -> now.shape().isFlat()).isPresent());
        Optional<Obstacle> specular = shown.filter(Obstacle::isSpecular);
        specularAngle.setEnabled(specular.isPresent());
        Optional<WaypointPath> motion = shown.filter(Obstacle::isMoving).map(Obstacle::motion);
        speed.setEnabled(motion.isPresent());
        loop.setEnabled(motion.isPresent());
        x.setWorldValue(shown.map(now -> now.pose().x()).orElse(Double.NaN));
        y.setWorldValue(shown.map(now -> now.pose().y()).orElse(Double.NaN));
        heading.setWorldValue(
                shown.map(now -> shownHeading.toDegrees(now.pose().heading())).orElse(Double.NaN));
        glossy.setSelected(specular.isPresent());
        specularAngle.setWorldValue(specular.map(now -> shownSpecularAngle.toDegrees(now.specularAngle()))
                .orElse(Double.NaN));
        speed.setWorldValue(motion.map(WaypointPath::speed).orElse(Double.NaN));
        loop.setSelected(motion.filter(WaypointPath::loop).isPresent());
        waypoints.setPoints(shown.map(now -> now.motion().waypoints()).orElse(List.of()));
    }
}
