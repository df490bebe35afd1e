package faultline.gui.properties;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.metrics.Expectation;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** The fields of what a scenario expects. */
final class ExpectationForm extends JPanel {

    /** The expectation about collisions. */
    private enum ContactChoice {
        NOT_CHECKED,
        NONE,
        EXPECTED
    }

    private static final int STATE_COLUMNS = 2;
    private static final double USUAL_COVERAGE = 0.8;
    private static final double USUAL_RMS = 0.02;

    private final NamedChoice<ContactChoice> contact =
            new NamedChoice<>(ContactChoice.values(), value -> Messages.get("expect.contact." + value), value -> {});
    private final JCheckBox coverageBox = new JCheckBox(Messages.get("expect.form.coverage"));
    private final NumberSpinner coverage = new NumberSpinner("0.0##", 0, 1, 0.05, value -> {});
    private final JCheckBox rmsBox = new JCheckBox(Messages.get("expect.form.rms"));
    private final NumberSpinner rms = new NumberSpinner("0.000##", 0.0001, 10, 0.001, value -> {});
    private final Map<FollowerState, JCheckBox> states = new EnumMap<>(FollowerState.class);
    private final JCheckBox finalBox = new JCheckBox(Messages.get("expect.form.final"));
    private final NamedChoice<FollowerState> finalState =
            new NamedChoice<>(FollowerState.values(), StateText::name, value -> {});
    /** The states of the expectation that was shown last, in order; the form has no fields for some of them. */
    private transient List<Expectation.VisitedState> shownStates = List.of();
    /** Conditions that the form cannot show, such as states of other controllers. */
    private transient List<Expectation.Condition> others = List.of();

    ExpectationForm() {
        super(new GridBagLayout());
        add(FormConstraints.label("expect.form.contact", contact), FormConstraints.cell(0, 0));
        add(contact, FormConstraints.fillCell(1, 0));
        addOptional(1, coverageBox, coverage.withName("expect.form.coverage").withColumns(6));
        addOptional(2, rmsBox, rms.withName("expect.form.rms").withColumns(6));
        addOptional(3, finalBox, finalState);
        finalState.getAccessibleContext().setAccessibleName(finalBox.getText());
        contact.getAccessibleContext().setAccessibleName(Messages.get("expect.form.contact"));
        JPanel grid = new JPanel(new GridLayout(0, STATE_COLUMNS));
        for (FollowerState state : FollowerState.values()) {
            JCheckBox box = new JCheckBox(StateText.name(state));
            states.put(state, box);
            grid.add(box);
        }
        add(FormConstraints.label("expect.form.states", grid), FormConstraints.cell(0, 4));
        add(grid, FormConstraints.fillCell(1, 4));
    }

    private void addOptional(int row, JCheckBox box, JComponent field) {
        box.addItemListener(event -> field.setEnabled(box.isSelected()));
        field.setEnabled(false);
        add(box, FormConstraints.cell(0, row));
        add(field, FormConstraints.cell(1, row));
    }

    /** Shows an expectation, and offers the states that a controller has; all states if none of its own are known. */
    void setExpectation(Expectation expectation, List<ControllerState> known) {
        states.forEach((state, box) -> box.setEnabled(known.isEmpty() || known.contains(state)));
        finalBox.setEnabled(states.values().stream().anyMatch(JCheckBox::isEnabled));
        contact.setValue(ContactChoice.NOT_CHECKED);
        coverageBox.setSelected(false);
        coverage.setWorldValue(USUAL_COVERAGE);
        rmsBox.setSelected(false);
        rms.setWorldValue(USUAL_RMS);
        finalBox.setSelected(false);
        states.values().forEach(box -> box.setSelected(false));
        shownStates = expectation.conditions().stream()
                .filter(Expectation.VisitedState.class::isInstance)
                .map(Expectation.VisitedState.class::cast)
                .toList();
        others = new ArrayList<>(expectation.conditions());
        others.removeIf(this::show);
    }

    /** Returns the expectation of the fields. */
    Expectation expectation() {
        List<Expectation.Condition> conditions = new ArrayList<>();
        if (contact.getSelectedItem() != ContactChoice.NOT_CHECKED) {
            conditions.add(new Expectation.Collides(contact.getSelectedItem() == ContactChoice.EXPECTED));
        }
        if (coverageBox.isSelected()) {
            conditions.add(new Expectation.MinCoverage(coverage.doubleValue()));
        }
        if (rmsBox.isSelected()) {
            conditions.add(new Expectation.MaxDistanceRms(rms.doubleValue()));
        }
        conditions.addAll(visitedStates());
        if (finalBox.isSelected()) {
            conditions.add(new Expectation.FinalState((FollowerState) finalState.getSelectedItem()));
        } else {
            others.stream().filter(Expectation.FinalState.class::isInstance).forEach(conditions::add);
        }
        return new Expectation(conditions);
    }

    /** Returns the expected states: those that are still expected in their order, and then the new ones. */
    private List<Expectation.VisitedState> visitedStates() {
        List<Expectation.VisitedState> visited = new ArrayList<>(shownStates);
        visited.removeIf(condition -> states.containsKey(condition.state())
                && !states.get(condition.state()).isSelected());
        states.forEach((state, box) -> {
            Expectation.VisitedState condition = new Expectation.VisitedState(state);
            if (box.isSelected() && !shownStates.contains(condition)) {
                visited.add(condition);
            }
        });
        return visited;
    }

    /** Shows a condition in its fields, and returns whether there are fields for it. */
    private boolean show(Expectation.Condition shown) {
        return shown.match(new Expectation.ConditionCases<>(
                collides -> {
                    contact.setValue(collides.wanted() ? ContactChoice.EXPECTED : ContactChoice.NONE);
                    return true;
                },
                minCoverage -> {
                    coverageBox.setSelected(true);
                    coverage.setWorldValue(minCoverage.share());
                    return true;
                },
                maxRms -> {
                    rmsBox.setSelected(true);
                    rms.setWorldValue(maxRms.metres());
                    return true;
                },
                visited -> {
                    Optional<JCheckBox> box = Optional.ofNullable(states.get(visited.state()));
                    box.ifPresent(found -> found.setSelected(true));
                    return box.isPresent();
                },
                last -> {
                    if (last.state() instanceof FollowerState state) {
                        finalBox.setSelected(true);
                        finalState.setValue(state);
                    }
                    return last.state() instanceof FollowerState;
                }));
    }
}
