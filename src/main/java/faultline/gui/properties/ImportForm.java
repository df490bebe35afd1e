package faultline.gui.properties;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.floorplan.FloorPlan;
import faultline.floorplan.FloorPlanException;
import faultline.floorplan.FloorPlanProblem;
import faultline.floorplan.MapDescription;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.FileNames;
import faultline.gui.edit.Rounding;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.FormDialog;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import faultline.io.Message;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.RenderRequest;
import faultline.paint.scene.Layer;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.GridBagLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.ImageIcon;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;

/**
 * A form to make a scenario of a floor plan: how the plan is traced, with a preview. The plan is read off the event
 * dispatch thread, one reading at a time.
 */
public final class ImportForm extends JPanel {

    private static final Dimension PREVIEW_SIZE = new Dimension(520, 380);
    private static final int GAP = 12;
    private static final int STATUS_ROWS = 3;
    /** Fewer than fit below the preview, which determines the width. */
    private static final int STATUS_COLUMNS = 20;

    private static final double USUAL_RESOLUTION = 0.05;
    private static final double MAX_RESOLUTION = 10;
    private static final int MAX_CELLS = 100_000;
    private static final double MAX_SMOOTHING = 20;

    /** The problems of a plan that other values of the fields may mend. */
    private static final Set<Message.Template> MENDABLE = Set.of(
            FloorPlanProblem.MEMORY, FloorPlanProblem.SEGMENTS, FloorPlanProblem.MAP_SIZE, FloorPlanProblem.NO_ROOM);

    /** A read plan with its picture, and why the robot cannot start there; empty if it can. */
    private record Preview(
            FloorPlanFiles.ImportedPlan read, BufferedImage picture, Camera camera, String obstruction) {}

    private final transient Path file;
    private final NumberSpinner resolution =
            new NumberSpinner("0.00##", 0.001, MAX_RESOLUTION, 0.01, value -> startReading());
    private final JCheckBox negate = new JCheckBox(Messages.get("import.negate"));
    private final NumberSpinner threshold = new NumberSpinner("0.0##", 0, 1, 0.05, value -> startReading());
    private final JCheckBox unknownIsWall = new JCheckBox(Messages.get("import.unknown"));
    private final NumberSpinner minCells = new NumberSpinner("0", 1, MAX_CELLS, 1, value -> startReading());
    private final NumberSpinner smoothing = new NumberSpinner("0.0#", 0, MAX_SMOOTHING, 0.5, value -> startReading());
    private final JCheckBox findsStart = new JCheckBox(Messages.get("import.findsStart"), true);
    private final StartFields start = new StartFields(this::startReading);
    private final JLabel picture = new JLabel("", SwingConstants.CENTER);
    private final JTextArea status = UiText.wrappedText();
    /** Null while the plan is read, or if it cannot be read. */
    private transient Scenario scenario;
    /** That of the picture; null before the first picture. */
    private transient Camera camera;
    /** How often the plan was to be read; only the result of the newest request counts. */
    private int requests;

    private boolean isReading;
    /** Runs after each reading. */
    private transient Runnable onRead = () -> {};

    /** Shows the dialog and returns the scenario; empty if cancelled. */
    public static Optional<Scenario> showDialog(Component parent, Path file) {
        ImportForm form = new ImportForm(file);
        String title = Messages.get("import.title", FileNames.lastOf(file));
        boolean accepted = FormDialog.showDialog(parent, title, form, form.firstField(), () -> form.findProblem(title));
        return accepted ? form.scenario() : Optional.empty();
    }

    private Component firstField() {
        return FloorPlan.isYaml(file) ? unknownIsWall : resolution.textField();
    }

    /** Commits the numbers, waits for the plan, and returns what is wrong; empty if there is a scenario. */
    private Optional<FormDialog.FormProblem> findProblem(String title) {
        Optional<FormDialog.FormProblem> refused = FormDialog.describeRefusedNumber(this);
        if (refused.isPresent()) {
            return refused;
        }
        awaitReading(title);
        return scenario().isPresent()
                ? Optional.empty()
                : Optional.of(new FormDialog.FormProblem(isReading ? "" : status(), firstField()));
    }

    /** Shows that the plan is read until it has been read or the user cancels. */
    private void awaitReading(String title) {
        if (isReading) {
            JOptionPane pane = new JOptionPane(Messages.get("import.reading"), JOptionPane.INFORMATION_MESSAGE);
            pane.setOptions(new Object[] {UIManager.getString("OptionPane.cancelButtonText")});
            JDialog dialog = pane.createDialog(this, title);
            onRead = dialog::dispose;
            dialog.setVisible(true);
            onRead = () -> {};
            dialog.dispose();
        }
    }

    ImportForm(Path file) {
        super(new BorderLayout(GAP, GAP));
        this.file = file;
        JPanel fields = new JPanel(new GridBagLayout());
        if (!FloorPlan.isYaml(file)) {
            FormConstraints.addRow(fields, 0, "import.resolution", resolution.withColumns(6));
            fields.add(UiText.tip(negate, "import.negate.tip"), FormConstraints.fillRow(0, 1));
            FormConstraints.addRow(fields, 2, "import.threshold", threshold.withColumns(6));
            threshold.setTip("import.threshold.tip");
        }
        fields.add(unknownIsWall, FormConstraints.fillRow(0, 3));
        FormConstraints.addRow(fields, 4, "import.minCells", minCells.withColumns(6));
        FormConstraints.addRow(fields, 5, "import.smoothing", smoothing.withColumns(6));
        fields.add(findsStart, FormConstraints.fillRow(0, 6));
        start.addTo(fields, 7);
        start.setEnabled(false);
        negate.addActionListener(event -> startReading());
        unknownIsWall.addActionListener(event -> startReading());
        findsStart.addActionListener(event -> {
            start.setEnabled(!findsStart.isSelected());
            startReading();
        });
        resolution.setWorldValue(USUAL_RESOLUTION);
        threshold.setWorldValue(MapDescription.DEFAULT_OCCUPIED);
        minCells.setWorldValue(1);
        picture.setPreferredSize(PREVIEW_SIZE);
        UiText.tip(picture, "import.preview.tip");
        MouseAdapter placing = new StartPlacing();
        picture.addMouseListener(placing);
        picture.addMouseMotionListener(placing);
        picture.getAccessibleContext().setAccessibleName(Messages.get("import.preview"));
        status.setRows(STATUS_ROWS);
        status.setColumns(STATUS_COLUMNS);
        status.getAccessibleContext().setAccessibleName(Messages.get("import.status"));
        add(fields, BorderLayout.NORTH);
        add(picture, BorderLayout.CENTER);
        add(status, BorderLayout.SOUTH);
        NumberSpinner.findIn(this).forEach(NumberSpinner::keepInvalidText);
        startReading();
    }

    /** Reads the plan with the present values, when a reading that has begun has ended. */
    private void startReading() {
        requests++;
        scenario = null;
        status.setText(Messages.get("import.reading"));
        if (!isReading) {
            isReading = true;
            read();
        }
    }

    private void read() {
        assert EventQueue.isDispatchThread();
        int request = requests;
        FloorPlanFiles.ImagePixels pixels =
                new FloorPlanFiles.ImagePixels(resolution.doubleValue(), negate.isSelected(), threshold.doubleValue());
        FloorPlan.Options options =
                new FloorPlan.Options(unknownIsWall.isSelected(), minCells.intValue(), smoothing.doubleValue());
        Pose wantedStart = findsStart.isSelected() ? null : start.pose();
        Palette palette = Theme.current().palette();
        BackgroundTasks.compute(
                () -> preview(FloorPlanFiles.read(file, pixels, options, wantedStart), palette),
                preview -> end(request, () -> show(preview)),
                failure -> end(request, () -> showFailure(failure)));
    }

    private static Preview preview(FloorPlanFiles.ImportedPlan read, Palette palette) {
        try (Simulation simulation = new Simulation(read.scenario().setup(), ControllerMode.DIRECT)) {
            Camera camera = FrameRenderer.fitCamera(simulation.snapshot(), PREVIEW_SIZE.width, PREVIEW_SIZE.height);
            RenderRequest request = new RenderRequest(simulation.frame(), camera, palette, EnumSet.of(Layer.CONES));
            return read.noRoom().isEmpty()
                    ? new Preview(
                            read,
                            request.toImage(1),
                            camera,
                            PropertiesForm.findObstruction(read.scenario()).orElse(""))
                    : new Preview(read, groundImage(request), camera, read.noRoom());
        }
    }

    /** Renders a plan without a robot. */
    private static BufferedImage groundImage(RenderRequest request) {
        BufferedImage image = new BufferedImage(PREVIEW_SIZE.width, PREVIEW_SIZE.height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        try {
            DrawContext context = new DrawContext(graphics, request.camera(), request.palette());
            request.painter().paintGround(context, request.frame().snapshot());
        } finally {
            graphics.dispose();
        }
        return image;
    }

    private void end(int request, Runnable action) {
        if (request == requests) {
            isReading = false;
            action.run();
            onRead.run();
        } else {
            read();
        }
    }

    private void show(Preview preview) {
        FloorPlan plan = preview.read().plan();
        picture.setIcon(new ImageIcon(preview.picture()));
        camera = preview.camera();
        setUsable(true);
        if (!preview.obstruction().isEmpty()) {
            status.setText(preview.obstruction() + notes(preview.read()));
            return;
        }
        scenario = preview.read().scenario();
        if (findsStart.isSelected()) {
            start.setPose(scenario.setup().start());
        }
        status.setText(Messages.get(
                        "import.result",
                        Integer.toString(plan.grid().width()),
                        Integer.toString(plan.grid().height()),
                        NumberText.format("%.2f", scenario.setup().world().width()),
                        NumberText.format("%.2f", scenario.setup().world().height()),
                        Integer.toString(plan.rings().size()),
                        Integer.toString(plan.segmentCount()))
                + notes(preview.read()));
    }

    /** Returns the notes on a map file, each on a line of its own. */
    private static String notes(FloorPlanFiles.ImportedPlan read) {
        return read.notes().stream()
                .map(note -> "\n" + ErrorMessages.capitalised(Messages.get(note)))
                .collect(Collectors.joining());
    }

    private void showFailure(Throwable failure) {
        picture.setIcon(null);
        camera = null;
        status.setText(ErrorMessages.describeAsSentence(failure, file));
        setUsable(!(failure instanceof IOException)
                || failure instanceof FloorPlanException known
                        && MENDABLE.contains(known.reason().template()));
    }

    /** Enables or disables the fields and the button that accepts the form. */
    private void setUsable(boolean usable) {
        List.of(resolution, negate, threshold, unknownIsWall, minCells, smoothing, findsStart)
                .forEach(field -> field.setEnabled(usable));
        start.setEnabled(usable && !findsStart.isSelected());
        FormDialog.setAcceptable(this, usable);
    }

    /** Returns the scenario of the plan; empty while it is read, or if it cannot be read. */
    Optional<Scenario> scenario() {
        return Optional.ofNullable(scenario);
    }

    /** Places the start with the mouse; the plan is read when the button is released. */
    private final class StartPlacing extends MouseAdapter {

        private boolean placing;

        @Override
        public void mousePressed(MouseEvent event) {
            placing = SwingUtilities.isLeftMouseButton(event) && camera != null;
            mouseDragged(event);
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            if (placing && camera != null) {
                findsStart.setSelected(false);
                start.setEnabled(true);
                start.setPosition(Rounding.round(camera.toWorld(inPicture(event))));
            }
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (placing && SwingUtilities.isLeftMouseButton(event)) {
                placing = false;
                startReading();
            }
        }

        /** Returns the place of the pointer in the picture, which is centred. */
        private Vector2 inPicture(MouseEvent event) {
            return new Vector2(
                    event.getX() - (picture.getWidth() - PREVIEW_SIZE.width) / 2.0,
                    event.getY() - (picture.getHeight() - PREVIEW_SIZE.height) / 2.0);
        }
    }

    /** Returns the text below the preview. */
    String status() {
        return status.getText();
    }
}
