//! Tables in the forms that people have them, each read to the same names and numbers.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::*;

const OPTIONS: Options<'_> = Options { help: "name, name" };

/// Names with units, and numbers, of every block.
/// The names of a block's columns, and its rows of numbers.
type Block = (String, Vec<Vec<Option<f64>>>);

fn read(text: &str) -> Result<Vec<Block>, String> {
    let table = DelimitedTable::read(&SourceText::new("t.txt", text.to_owned()), &OPTIONS).map_err(|error| error.rendered())?;
    let mut buffer = String::new();
    Ok(table
        .blocks()
        .iter()
        .map(|block| {
            let mut names: Vec<String> = block.header.iter().map(|cell| table.text(*cell).into_owned()).collect();
            for (name, unit) in names.iter_mut().zip(&block.units) {
                *name = format!("{name}|{}", table.text(*unit));
            }
            let said: Vec<String> = block.stated.iter().map(|stated| format!("{}={}; ", stated.key, stated.value)).collect();
            let rows =
                table.rows(block).map(|row| row.iter().map(|cell| table.number(*cell, &Scale::ONE, &mut buffer)).collect()).collect();
            (format!("{}{}", said.concat(), names.join("~")), rows)
        })
        .collect())
}

fn one(text: &str, names: &str, rows: &[&[f64]]) {
    let found = read(text).unwrap_or_else(|error| panic!("{text}\n{error}"));
    let right: Vec<Vec<Option<f64>>> = rows.iter().map(|row| row.iter().copied().map(Some).collect()).collect();
    assert_eq!(found, vec![(names.to_owned(), right)], "{text}");
}

#[test]
fn separators_and_decimal_signs() {
    let rows: &[&[f64]] = &[&[0.1, 812.5], &[1.0, 1300.25]];
    one("f,E\n0.1,812.5\n1.0,1300.25\n", "f~E", rows);
    one("f, E\r\n0.1, 812.5\r\n1.0, 1300.25", "f~E", rows);
    one("f;E\r0,1;812,5\r1,0;1300,25\r", "f~E", rows);
    one("f\tE\n0,1\t812,5\n\n1,0\t1300,25\n", "f~E", rows);
    one("f E\n0.1   812.5\n 1.0 1300.25\n", "f~E", rows);
    one("f E\n0,1 812,5\n1,0 1300,25\n", "f~E", rows);
    one("f,E\n0.1,812.5\n1.0,\"1,300.25\"\n", "f~E", rows);
    one("\"f\",\"E\"\n\"0,1\",\"812,5\"\n\"1,0\",\"1.300,25\"\n", "f~E", rows);
    one("f;E\n0,1;812,5\n1,0;1 300,25\n", "f~E", rows);
    one("f;E\n0.1;812.5\n1.0;1'300.25\n", "f~E", rows);
    // Every word of the header holds another separator.
    one("f, s; E, a; x\n1;2;3\n4;5;6\n", "f, s~E, a~x", &[&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]]);
    one("storage modulus (MPa)  loss modulus (MPa)\n1 2\n3 4\n", "storage modulus (MPa)~loss modulus (MPa)", &[&[1.0, 2.0], &[3.0, 4.0]]);
}

#[test]
fn what_stands_around_the_numbers() {
    let rows: &[&[f64]] = &[&[1.0, 2.0], &[3.0, 4.0]];
    one("# a\n% b\n// c\nf,E\n1,2\n# d\n3,4\n", "f~E", rows);
    one("f;E\nHz;MPa\n1;2\n3;4\n", "f|Hz~E|MPa", rows);
    one("f;E\n[Hz];[MPa]\n1;2\n3;4\n", "f|[Hz]~E|[MPa]", rows);
    one("f;E\n-;%\n1;2\n3;4\n", "f|-~E|%", rows);
    one("d;E\n%;MPa\n1;2\n3;4\n", "d|%~E|MPa", rows);
    one("# f E\n1 2\n3 4\n", "f~E", rows);
    one("##f/Hz;E/MPa\n1;2\n3;4\n", "f/Hz~E/MPa", rows);
    one("Sample;X 12\nDate;12.03.2021\nGeometry;3;10;2\nf;E\n1;2\n3;4\nend of file\n", "Date=12.03.2021; f~E", rows);
    one("f;E;\n1;2;\n3;4;\n", "f~E", &[&[1.0, 2.0], &[3.0, 4.0]].map(|row| row as &[f64]));
    one("\"f\n(Hz)\";\"E\"\"\"\n1;2\n3;4\n", "f (Hz)~E\"", rows);
}

#[test]
fn blocks() {
    let text = "Temperature: 25 °C\nf;E\n1;2\n3;4\n\nTemperature: 35,5 °C\nf;E\n5;6\nTemperature;45;°C\n7;8\n";
    let found = read(text).unwrap();
    let names: Vec<&str> = found.iter().map(|block| block.0.as_str()).collect();
    assert_eq!(names, ["Temperature=25 °C; f~E", "Temperature=35,5 °C; f~E", "Temperature=45 °C; f~E"]);
    assert_eq!(found.iter().map(|block| block.1.len()).collect::<Vec<_>>(), [2, 1, 1]);
    assert_eq!(DelimitedTable::quantity("35,5 °C"), Some(("3.55e1".to_owned(), "°C".to_owned())));
}

#[test]
fn what_stays_open_is_refused() {
    for (text, says) in [
        ("f;E\n1,234;5\n2,345;6\n", "can be 1.234 or 1234"),
        ("f;E\n0,5;1.234\n1,5;6\n", "can be 1.234 or 1234"),
        ("f;E\n0.5;1,234\n1.5;6\n", "can be 1.234 or 1234"),
        ("f;E\n0.5;1\n0,5;6\n", "decimal points and decimal commas"),
        ("f,E\n0,5,1,5\n0,6,1,6\n", "has 4 cells, the header 2"),
        ("1,2\n3,4\n", "no line that names its columns"),
        ("f,E\n", "no rows of numbers"),
        ("", "is empty"),
        ("f,E\n1,2\n3\n", "line 3 of \"t.txt\" has 1 cells, the header 2"),
    ] {
        let refused = read(text).unwrap_err();
        assert!(refused.contains(says), "{text}\n{refused}");
    }
    // Either remedy works where it is pasted.
    for (text, remedies) in [
        ("f;E\n1,234;5\n2,345;6\n", ["1,2340", "1,234.0"]),
        ("f;E\n0,5;7\n1.234;6\n", ["1,234", "1.234,0"]),
        ("f;E\n0.5;7\n1,234;6\n", ["1.234", "1,234.0"]),
    ] {
        let refused = read(text).unwrap_err();
        let cell = if text.contains("1.234") { "1.234" } else { "1,234" };
        for (remedy, right) in remedies.iter().zip([1.234, 1234.0]) {
            assert!(refused.contains(&format!("`{remedy}`")), "{refused}");
            let found = read(&text.replacen(cell, remedy, 1)).unwrap();
            assert!(found[0].1.iter().any(|row| row[0] == Some(right)), "{remedy}: {found:?}");
        }
    }
    // The rest of the file settles it.
    one("f,E\n0.5,\"1,234\"\n1.5,6\n", "f~E", &[&[0.5, 1234.0], &[1.5, 6.0]]);
    one("f;E\n0,5;1,234\n1,5;6\n", "f~E", &[&[0.5, 1.234], &[1.5, 6.0]]);
}

/// A cell that is no number is no reason to drop its row.
#[test]
fn spoilt_rows_stay() {
    let found = read("f;E\n1;2\n3;x4\n5;6\n").unwrap();
    assert_eq!(found[0].1, vec![vec![Some(1.0), Some(2.0)], vec![Some(3.0), None], vec![Some(5.0), Some(6.0)]]);
}

/// 100 000 rows of five columns take a fraction of a second also without optimisation; the reader that users run is held to 0.3 s by `viscotack verify`.
#[test]
fn large_tables_are_read_at_once() {
    let mut text = String::from("t (s);E (Pa);a;b;c\n");
    for row in 0..20_000 {
        text.push_str(&format!("{row},5;1234567,89;0,001;3;4\n"));
    }
    let start = std::time::Instant::now();
    let found = read(&text).unwrap();
    assert_eq!(found[0].1.len(), 20_000);
    assert!(start.elapsed().as_secs_f64() < 5.0, "{:?}", start.elapsed());
}
