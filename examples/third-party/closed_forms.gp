\\ SPDX-License-Identifier: BSD-3-Clause
\\ Answers the questions of `edgeproof points` to 30 digits with PARI/GP (package pari-gp):
\\
\\     edgeproof check questions.toml --exec 'gp -q closed_forms.gp' --digits 30
\\
default(realprecision, 57);
real_atanh(z) = if(abs(z) < 1, atanh(z), atanh(1/z));
wedge(name, a, u, scale) = {
    if(name == "P", return(scale*a));
    if(name == "c_0", return(scale/Pi*sqrt(2/a)));
    scale/Pi*acosh(a/abs(a - u))
};
cylinder(name, a, u, scale) = {
    if(name == "P", return(scale*Pi*a^2/4));
    if(name == "c_0", return(scale*sqrt(2*a)/2));
    if(name == "c_1", return(-scale*sqrt(2*a)/(8*a)));
    scale/2*sqrt(u*(2*a - u))
};
flat_and_rounded(name, a, u, t, scale) = {
    my(flat = asin(t/a), x = abs(a - u)/a, y = sqrt(u*(2*a - u))/a);
    if(name == "P", return(scale*a^2/4*(Pi - 2*flat - sin(2*flat))));
    scale *= a/(2*Pi);
    if(name == "c_0", return(scale*(Pi - 2*flat)*sqrt(2/a)));
    scale*((Pi - 2*flat)*y + 2*x*real_atanh(tan(flat)*y/x) - 2*t/a*real_atanh(y/cos(flat)))
};
\\ A decimal read exactly: digits over a power of ten.
exact(text) = {
    my(parts, mantissa, exponent = 0);
    if(text == "", return(0));
    parts = strsplit(text, "e");
    if(#parts == 2, exponent = eval(parts[2]));
    mantissa = strsplit(parts[1], ".");
    if(#mantissa == 1, return(eval(parts[1])*10^exponent));
    eval(mantissa[1])*10^exponent + eval(strjoin(["1", mantissa[2]]))*10^(exponent - #mantissa[2])
        - 10^exponent
};
main() = {
    my(names, rows = externstr("cat"), cell, n, value);
    print("id,value");
    for(i = 1, #rows,
        if(#rows[i] == 0 || strsplit(rows[i], "#")[1] == "", next);
        cell = strsplit(rows[i], ",");
        if(!names, names = Map(); for(k = 1, #cell, mapput(names, cell[k], k)); next);
        n = (key -> my(at); if(mapisdefined(names, key, &at), exact(cell[at])*1., 0));
        my(text = (key -> cell[mapget(names, key)]), name = text("quantity"));
        value = if(text("kind") == "flat-and-rounded",
            flat_and_rounded(name, n("a"), n("u"), n("t"), n("contact_modulus")/n("R")),
            if(n("m") == 0, wedge, cylinder)(name, n("a"), n("u"), n("contact_modulus")*n("C")));
        print(text("id"), ",", strjoin(strsplit(strprintf("%.34e", value), " ")));
    );
};
main();
quit
