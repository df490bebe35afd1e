package faultline.campaign.plan;

import java.util.List;

/**
 * Something that a plan varies. Every level of a factor is combined with every level of the others.
 *
 * @param kind which element of the plan it is of
 * @param columns what it adds to {@code runs.csv}
 * @param levels at least one
 */
record Factor(FactorKind kind, List<Column> columns, List<Level> levels) {

    Factor {
        columns = List.copyOf(columns);
        levels = List.copyOf(levels);
    }

    /**
     * One level of a factor.
     *
     * @param cells what it writes in the factor's columns
     * @param edits what it changes in the scenario
     */
    record Level(List<AttributeValue> cells, List<ScenarioChange> edits) {
        Level {
            cells = List.copyOf(cells);
            edits = List.copyOf(edits);
        }
    }
}
