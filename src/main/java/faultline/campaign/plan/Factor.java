package faultline.campaign.plan;

import java.util.Collections;
import java.util.List;

/**
 * A factor: a variable of a plan. Every level of a factor is combined with every level of the others.
 *
 * @param kind the kind of its element in the plan
 * @param columns its columns in {@code runs.csv}
 * @param levels its levels, at least one
 */
record Factor(FactorKind kind, List<Column> columns, List<Level> levels) {

    Factor {
        columns = List.copyOf(columns);
        // A copy would make levels that are made on demand.
        levels = Collections.unmodifiableList(levels);
    }

    /** Returns some levels that together set every attribute that the factor sets; levels of faults set none. */
    List<Level> settingLevels() {
        return switch (kind) {
            case FAULTS -> List.of();
            case SET, MASKS -> levels.subList(0, 1);
            case VARIANTS -> levels;
        };
    }

    /** One level of a factor: the values in its columns, and the changes of the scenario. */
    record Level(List<AttributeValue> cells, List<ScenarioChange> edits) {
        Level {
            cells = List.copyOf(cells);
            edits = List.copyOf(edits);
        }
    }
}
