A=target/debug/asperity
time $A curve /tmp/wheel.toml --load 80kN --model gw,ke,jg --format table
time $A curve /tmp/wheel.toml --load 10kN:80kN:8 --model ke --quantity approach-beyond-hertz,area,contacts,unloading-stiffness,tangential-stiffness,central-area-fraction,effective-radius --format table
$A curve /tmp/wheel.toml --approach 50um,100um --model ke --format table
$A curve /tmp/wheel.toml --approach 50um,100um --model ke --format table --quantity force,pressure,area-fraction
$A curve /tmp/wheel.toml --load 1kN  --format table
$A curve /tmp/roller.toml --load 1kN --model gw,jg --format table
$A curve /tmp/wheel.toml --pressure 1e6
$A curve /tmp/wheel.toml --model ke
$A joint /tmp/wheel.toml --preload 1kN
$A check /tmp/wheel.toml
$A check /tmp/wheel.toml --load 1kN
$A export /tmp/wheel.toml --model ke --load 1:10:3
$A bem /tmp/wheel.toml --load 1kN
$A fit /tmp/wheel.toml --free hardness --data /tmp/x.csv
