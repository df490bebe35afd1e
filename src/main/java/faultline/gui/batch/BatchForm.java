package faultline.gui.batch;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.ValueSyntax;
import faultline.campaign.run.CampaignRunner;
import faultline.control.ControllerSpec;
import faultline.external.ControllerChoice;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.FormDialog;
import faultline.gui.form.FormDialog.FormProblem;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.TitledSection;
import faultline.gui.text.Messages;
import faultline.gui.text.TextListener;
import faultline.gui.theme.FieldBorder;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.UiText;
import faultline.gui.timeline.CommandRole;
import faultline.io.DecimalText;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.awt.Insets;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;

/** The fields of a batch: seeds, times, controller, sensors and faults. */
final class BatchForm extends JPanel {

    private static final int COLUMNS = 9;

    private static final double EARLIEST_SHARE = 0.1;
    private static final double LATEST_SHARE = 0.5;

    /** The least duration, in the unit of the first suggestion for the start of faults: seconds or fractions of one. */
    private static final double MIN_UNITS = 2;

    private final Scenario scenario;
    private final NumberSpinner seeds = number("0", 1, 1_000_000, 1, "batch.seeds");
    private final NumberSpinner firstSeed =
            number("0", -CampaignPlan.MAX_SEED, CampaignPlan.MAX_SEED, 1, "batch.firstSeed");
    private final NumberSpinner duration = number("0.0##", 0.001, 1e6, 10, "batch.duration");
    private final JCheckBox untilVerdict = UiText.text(new JCheckBox(), "batch.untilVerdict");
    private final NamedChoice<DiagnosisChoice> diagnosis = new NamedChoice<>(
            DiagnosisChoice.values(), value -> Messages.get("batch.diagnosis." + value), ignored -> updateCount());
    private final NamedChoice<BatchControllerItem> controller;
    /** What there is to know about the controller, empty for nothing. */
    private final JLabel controllerRemark = new JLabel();
    /** How the timeline overrules the controller or the diagnosis, empty if it does not. */
    private final JLabel overruled = new JLabel();
    /** Whether the window starts a program to drive the robot, which a batch does not. */
    private boolean program;

    private final NumberSpinner jobs = number("0", 1, CampaignRunner.MAX_JOBS, 1, "batch.jobs");
    private final JTextField onset = new JTextField(COLUMNS);
    private final JCheckBox healthy = UiText.text(new JCheckBox("", true), "batch.healthy");
    private final List<JCheckBox> sensors;
    private final GridLayout sensorLayout = new GridLayout(0, 2);
    private final JPanel sensorBoxes = new JPanel(sensorLayout);
    private final FaultChoices faults;
    private final JLabel count = new JLabel(" ");
    private final JLabel remark = new JLabel(" ");
    private final GridBagLayout layout = new GridBagLayout();
    private final JPanel sections = new JPanel(layout);
    private final TitledSection runSection;
    private final TitledSection sensorSection = new TitledSection("batch.section.sensors", sensorBoxes);
    private final TitledSection faultSection;
    private final JScrollPane scroll;
    private Arrangement arrangement = Arrangement.WIDE;
    private int row;

    /** Creates a form for a scenario. */
    BatchForm(Scenario scenario) {
        super(new BorderLayout());
        this.scenario = scenario;
        RobotSpec robot = scenario.setup().robot();
        controller = new NamedChoice<>(
                items(ControllerChoice.SCENARIO), value -> value.text(scenario.setup()), ignored -> updateCount());
        sensors = robot.sensors().stream().map(this::createSensorBox).toList();
        faults = new FaultChoices(this::updateCount);
        setInitialValues();
        sensors.forEach(sensorBoxes::add);
        runSection = new TitledSection("batch.section.runs", createRunFields());
        faultSection = new TitledSection("batch.section.faults", faults);
        Stream.of(runSection, sensorSection, faultSection).forEach(sections::add);
        scroll = ScreenFit.scrolling(sections);
        add(scroll, BorderLayout.CENTER);
        RefreshSteps.add(count, label -> updateCount());
    }

    /** The ways to arrange the sections, with the numbers of columns of the faults and of the sensors. */
    private enum Arrangement {
        /** The faults beside the runs, in two columns, and the sensors below the faults. */
        WIDE(2, 4),
        /** The faults beside the runs, and the sensors below the runs. */
        MEDIUM(1, 2),
        /** The faults below the sensors, and those below the runs. */
        NARROW(1, 4);

        private final int faultColumns;
        private final int sensorColumns;

        Arrangement(int faultColumns, int sensorColumns) {
            this.faultColumns = faultColumns;
            this.sensorColumns = sensorColumns;
        }
    }

    /** Arranges the sections in the widest way that there is room for. */
    @Override
    public void doLayout() {
        int room = getWidth() - scroll.getVerticalScrollBar().getPreferredSize().width;
        for (Arrangement each : Arrangement.values()) {
            arrange(each);
            if (sectionsWidth() <= room) {
                break;
            }
        }
        super.doLayout();
    }

    /** Returns a size in which the form is wide. */
    @Override
    public Dimension getPreferredSize() {
        Arrangement now = arrangement;
        arrange(Arrangement.WIDE);
        int bar = scroll.getVerticalScrollBar().getPreferredSize().width;
        Dimension size = new Dimension(sectionsWidth() + bar, super.getPreferredSize().height);
        arrange(now);
        return size;
    }

    private int sectionsWidth() {
        return layout.preferredLayoutSize(sections).width;
    }

    private void arrange(Arrangement next) {
        arrangement = next;
        faults.arrange(arrangement.faultColumns);
        boolean wide = arrangement == Arrangement.WIDE;
        boolean narrow = arrangement == Arrangement.NARROW;
        arrangeSensors(arrangement.sensorColumns, (wide ? faultSection : runSection).getPreferredSize().width);
        place(runSection, 0, 0, wide ? 2 : 1);
        place(sensorSection, wide ? 1 : 0, 1, 1);
        place(faultSection, narrow ? 0 : 1, narrow ? 2 : 0, arrangement == Arrangement.MEDIUM ? 2 : 1);
        sections.invalidate();
    }

    private void place(TitledSection section, int column, int row, int height) {
        GridBagConstraints cell = FormConstraints.cell(column, row);
        cell.insets = new Insets(0, 0, 0, 0);
        cell.anchor = GridBagConstraints.FIRST_LINE_START;
        cell.fill = GridBagConstraints.HORIZONTAL;
        cell.gridheight = height;
        cell.weightx = section == faultSection ? 1 : 0;
        cell.weighty = row + height > 1 ? 1 : 0;
        layout.setConstraints(section, cell);
    }

    /** Shows the sensors in as many columns as fit into a width, at most a number, at least one. */
    private void arrangeSensors(int maxColumns, int width) {
        int columns = maxColumns;
        sensorLayout.setColumns(columns);
        while (columns > 1 && sensorLayout.preferredLayoutSize(sensorBoxes).width > width) {
            columns--;
            sensorLayout.setColumns(columns);
        }
        sensorBoxes.invalidate();
    }

    private void setInitialValues() {
        double seconds = scenario.setup().duration();
        seeds.setWorldValue(10);
        long seed = scenario.setup().seed();
        firstSeed.setWorldValue(seed >= -CampaignPlan.MAX_SEED && seed <= CampaignPlan.MAX_SEED ? seed : 1);
        duration.setWorldValue(seconds);
        jobs.setWorldValue(Runtime.getRuntime().availableProcessors());
        // Whole seconds, whole milliseconds, or whole microseconds.
        double scale = seconds >= MIN_UNITS ? 1 : seconds * 1000 >= MIN_UNITS ? 1000 : 1_000_000;
        double earliest = Math.rint(EARLIEST_SHARE * seconds * scale);
        double latest = Math.max(earliest + 1, Math.floor(LATEST_SHARE * seconds * scale));
        onset.setText(DecimalText.format(earliest / scale) + ".." + DecimalText.format(latest / scale));
    }

    private BatchControllerItem[] items(ControllerChoice chosen) {
        return BatchControllerItem.items(scenario.setup(), chosen, program).toArray(BatchControllerItem[]::new);
    }

    /**
     * Offers the controller that drives the robot of the window, and selects it if it was not offered before, given
     * whether it is a program. One that was offered stays if the window now uses that of the scenario, which it does
     * after a run of the batch has been opened.
     */
    void setChosen(ControllerChoice chosen, boolean startsProgram) {
        program = startsProgram;
        BatchControllerItem[] items = items(chosen);
        boolean offered = IntStream.range(0, controller.getItemCount())
                .mapToObj(controller::getItemAt)
                .toList()
                .containsAll(List.of(items));
        if (!offered) {
            controller.setModel(new DefaultComboBoxModel<>(items));
        }
        updateCount();
    }

    private void updateRemark() {
        controllerRemark.setVisible(program);
        controllerRemark.setText(program ? Messages.get("batch.controller.program") : "");
        controllerRemark.setToolTipText(program ? Messages.get("batch.controller.program.tip") : null);
    }

    /** Returns the name and the jars of the chosen controller. */
    ControllerChoice controllerChoice() {
        return controller.value().choice();
    }

    private JCheckBox createSensorBox(SensorSpec sensor) {
        JCheckBox box = new JCheckBox(sensor.id(), true);
        box.addActionListener(event -> updateCount());
        return box;
    }

    private NumberSpinner number(String pattern, double min, double max, double step, String key) {
        NumberSpinner spinner = new NumberSpinner(pattern, min, max, step, ignored -> updateCount())
                .withName(key)
                .withColumns(COLUMNS)
                .keepInvalidText();
        spinner.passKeysOn();
        return spinner;
    }

    private JPanel createRunFields() {
        JPanel fields = new JPanel(new GridBagLayout());
        addField(fields, "batch.seeds", seeds, "");
        addField(fields, "batch.firstSeed", firstSeed, "");
        addField(fields, "batch.duration", duration, "s");
        UiText.tip(untilVerdict, "batch.untilVerdict.tip");
        fields.add(untilVerdict, FormConstraints.fillRow(0, row++));
        UiText.tip(UiText.name(controller, "batch.controller"), "batch.controller.tip");
        // Below its label, because the names are long.
        fields.add(FormConstraints.label("batch.controller", controller), FormConstraints.fillRow(0, row++));
        fields.add(controller, FormConstraints.fillRow(0, row++));
        fields.add(controllerRemark, FormConstraints.fillRow(0, row++));
        UiText.name(diagnosis, "batch.diagnosis");
        fields.add(FormConstraints.label("batch.diagnosis", diagnosis), FormConstraints.cell(0, row));
        fields.add(diagnosis, FormConstraints.fillRow(1, row++));
        fields.add(UiText.tip(overruled, "batch.overruled.tip"), FormConstraints.fillRow(0, row++));
        addField(fields, "batch.jobs", jobs, "");
        UiText.tip(UiText.name(onset, "batch.onset"), "batch.syntax");
        onset.getDocument().addDocumentListener(new TextListener(this::updateCount));
        addField(fields, "batch.onset", onset, "s");
        healthy.addActionListener(event -> updateCount());
        fields.add(healthy, FormConstraints.fillRow(0, row++));
        fields.add(count, FormConstraints.fillRow(0, row++));
        fields.add(remark, FormConstraints.fillRow(0, row++));
        if (hasFaults(scenario)) {
            JLabel own = UiText.tip(UiText.label("batch.ownFaults"), "batch.ownFaults.tip");
            fields.add(own, FormConstraints.fillRow(0, row++));
        }
        return fields;
    }

    /** Returns whether faults begin on the timeline of a scenario; they do so in every run. */
    private static boolean hasFaults(Scenario scenario) {
        return scenario.setup().timeline().stream()
                .anyMatch(event -> CommandRole.of(event.command()).isFaultStart());
    }

    private void addField(JPanel fields, String key, JComponent field, String unit) {
        fields.add(FormConstraints.label(key, field), FormConstraints.cell(0, row));
        GridBagConstraints cell = FormConstraints.cell(1, row);
        cell.fill = GridBagConstraints.HORIZONTAL;
        fields.add(field, cell);
        fields.add(new JLabel(unit), FormConstraints.fillCell(2, row));
        row++;
    }

    private void updateCount() {
        // Fields call this while they are created.
        if (faults != null) {
            BatchPlan plan = plan();
            diagnosis.setEnabled(plan.scenario().setup().controller() instanceof ControllerSpec.WallFollowing);
            updateRemark();
            overruled.setText(OverruledChoice.describe(plan, !controllerChoice().isScenarioDefault()));
            overruled.setVisible(!overruled.getText().isEmpty());
            OptionalLong runs = plan.runCount();
            faults.markInvalidFields();
            FieldBorder.setValid(
                    onset,
                    plan.faults().isEmpty() || ValueSyntax.count(plan.onset()).isPresent());
            count.setText(runs.isPresent() ? countText(runs.getAsLong()) : Messages.get(invalidKey()));
            remark.setText(plan.hasLateFaults() ? Messages.get("batch.lateFaults") : " ");
        }
    }

    private static String countText(long runs) {
        return runs > CampaignPlan.MAX_RUNS ? tooManyText() : Messages.get("batch.count", Long.toString(runs));
    }

    private static String tooManyText() {
        return Messages.get("batch.tooMany", Long.toString(CampaignPlan.MAX_RUNS));
    }

    /** Moves the focus to the first field. */
    void focusFirstField() {
        seeds.textField().requestFocusInWindow();
    }

    /** Returns the plan of the fields. */
    BatchPlan plan() {
        Scenario driven = scenario.withSetup(controller.value().applyTo(scenario.setup()));
        boolean follows = driven.setup().controller() instanceof ControllerSpec.WallFollowing;
        return new BatchPlan(
                driven,
                firstSeed.longValue(),
                seeds.intValue(),
                duration.doubleValue(),
                untilVerdict.isSelected(),
                follows ? diagnosis.value() : DiagnosisChoice.SCENARIO,
                healthy.isSelected(),
                faults.chosen(),
                onset.getText().strip(),
                sensors.stream()
                        .filter(JCheckBox::isSelected)
                        .map(JCheckBox::getText)
                        .toList());
    }

    /** Returns how many threads make the runs. */
    int jobs() {
        return jobs.intValue();
    }

    /** Commits what is being typed, and returns what is wrong with the fields; empty if nothing is. */
    Optional<FormProblem> findProblem() {
        Optional<FormProblem> refused = FormDialog.describeRefusedNumber(this);
        if (refused.isPresent()) {
            return refused;
        }
        OptionalLong runs = plan().runCount();
        if (runs.isPresent()) {
            return runs.getAsLong() > CampaignPlan.MAX_RUNS
                    ? Optional.of(new FormProblem(tooManyText(), seeds.textField()))
                    : Optional.empty();
        }
        JTextField invalid = findInvalidField();
        return Optional.of(
                isReversedRange(invalid)
                        ? FormProblem.ofText(invalid, Messages.get("batch.reversed"))
                        : FormProblem.ofText(invalid));
    }

    /** Returns the first field whose text is not in the syntax of plans; there must be one. */
    private JTextField findInvalidField() {
        return faults.findInvalidField().orElse(onset);
    }

    private String invalidKey() {
        return isReversedRange(findInvalidField()) ? "batch.reversed" : "batch.invalid";
    }

    private static boolean isReversedRange(JTextField field) {
        return ValueSyntax.isReversedRange(field.getText());
    }
}
